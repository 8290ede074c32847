package rigibo.lab.hardcase;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Runs of cases at presets. They run on two threads, but results come in the order of the list, so
 * that the output is always the same.
 */
public final class Cases {

    /** The runs share nothing, but more threads would slow each other down on small machines. */
    private static final int MOST_THREADS = 2;

    private final List<Run> runs = new ArrayList<>();
    private final Sampling sampling;

    /** One of them. */
    private record Run(HardCase hardCase, Preset preset) {

        String name() {
            return name(hardCase, preset);
        }

        static String name(HardCase hardCase, Preset preset) {
            return hardCase.row() + " " + preset;
        }
    }

    /**
     * The runs of all chosen cases, at every preset from their fastest on.
     *
     * @param rows numbers such as {@code 20/10}, or {@code 20} for all its parts; empty means all
     *     cases but the long runs
     * @param atPresets at least one
     * @param sampling which variants of each
     * @throws IllegalArgumentException when a row names no case
     */
    public Cases(List<String> rows, List<Preset> atPresets, Sampling sampling) {
        this.sampling = sampling;
        List<HardCase> chosen = rows.isEmpty() ? HardCases.all() : chosen(rows);
        for (HardCase hardCase : chosen) {
            for (Preset preset : atPresets) {
                if (preset.compareTo(hardCase.fastest()) >= 0) {
                    runs.add(new Run(hardCase, preset));
                }
            }
        }
    }

    private Cases(Sampling sampling) {
        this.sampling = sampling;
    }

    /** The runs whose names do not satisfy a condition. */
    Cases without(Predicate<String> condition) {
        Cases rest = new Cases(sampling);
        runs.stream().filter(run -> !condition.test(run.name())).forEach(rest.runs::add);
        return rest;
    }

    /** The number of runs. */
    public int count() {
        return runs.size();
    }

    /** The names of all runs, in order: row and preset. */
    List<String> names() {
        return runs.stream().map(Run::name).toList();
    }

    /** The name of a result's run, as in {@link #names()}. */
    static String name(HardCase.Result result) {
        return Run.name(result.hardCase(), result.preset());
    }

    /**
     * Runs them all.
     *
     * @param each is handed every result in order, as soon as it and those before it are there
     * @return all results in order
     */
    public List<HardCase.Result> run(Consumer<HardCase.Result> each) {
        int threads = Math.min(MOST_THREADS, Runtime.getRuntime().availableProcessors());
        ExecutorService workers = Executors.newFixedThreadPool(threads);
        try {
            List<Future<HardCase.Result>> futures = new ArrayList<>();
            for (Run run : runs) {
                futures.add(workers.submit(() -> run(run.hardCase(), run.preset())));
            }
            return collect(futures, each);
        } finally {
            workers.shutdownNow();
        }
    }

    private static List<HardCase.Result> collect(
            List<Future<HardCase.Result>> futures, Consumer<HardCase.Result> each) {
        List<HardCase.Result> results = new ArrayList<>();
        try {
            for (Future<HardCase.Result> future : futures) {
                results.add(future.get());
                each.accept(results.get(results.size() - 1));
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted before the last case", stopped);
        } catch (ExecutionException broken) {
            throw new IllegalStateException(broken.getCause());
        }
        return results;
    }

    /** A case that breaks off must not hide the results of others. */
    private HardCase.Result run(HardCase hardCase, Preset preset) {
        try {
            return hardCase.run(preset, sampling);
        } catch (RuntimeException | AssertionError | StackOverflowError broken) {
            return hardCase.broken(preset, broken);
        }
    }

    private static List<HardCase> chosen(List<String> rows) {
        for (String row : rows) {
            if (everyCase().noneMatch(hardCase -> isNamed(hardCase.row(), row))) {
                List<String> known = everyCase().map(HardCase::row).toList();
                throw new IllegalArgumentException(
                        "there is no case '" + row + "'; there are " + String.join(" ", known));
            }
        }
        return everyCase()
                .filter(hardCase -> rows.stream().anyMatch(row -> isNamed(hardCase.row(), row)))
                .toList();
    }

    private static Stream<HardCase> everyCase() {
        return Stream.concat(HardCases.all().stream(), HardCases.longRuns().stream());
    }

    private static boolean isNamed(String row, String asked) {
        return row.equals(asked) || row.startsWith(asked + "/");
    }
}
