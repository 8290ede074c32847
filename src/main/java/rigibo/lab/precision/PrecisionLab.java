package rigibo.lab.precision;

import rigibo.backend.Pool;
import rigibo.lab.child.ClassFiles;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.child.Progress;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Finding;
import rigibo.lab.precision.probe.ProblemProbe;
import rigibo.lab.problem.Problem;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Has every problem solved by every engine at every setting that is asked for. */
final class PrecisionLab {

    private static final String LOG = "points.log";

    private final List<Task> tasks;
    private final Kept kept;
    private final long seed;
    private final BlockingQueue<MeasuringJava> free;

    PrecisionLab(Inquiry inquiry) {
        List<Engine> engines = Engines.all();
        tasks = inquiry.tasks(engines);
        seed = inquiry.seed();
        kept = new Kept(inquiry.out().resolve(LOG), key(engines));
        free =
                new LinkedBlockingQueue<>(
                        inquiry.extent() == Extent.QUICK
                                ? MeasuringJava.onEveryCore()
                                : List.of(MeasuringJava.onLastCore()));
    }

    /** The same for equal engines, problems and Java. */
    private static String key(List<Engine> engines) {
        Stream<Class<?>> measured = Stream.of(Pool.class, Problem.class, ProblemProbe.class);
        return Stream.concat(measured, engines.stream().map(Engine::getClass))
                        .map(member -> ClassFiles.of(member).hash())
                        .collect(Collectors.joining("-"))
                + "-"
                + Runtime.version();
    }

    /** Where what was found is kept. */
    Kept kept() {
        return kept;
    }

    /** How processes are run, in words. */
    String method() {
        return free.element().words();
    }

    /**
     * Runs what is missing.
     *
     * @param tell is told how far it is
     * @throws IllegalStateException when a process breaks off, with what it said
     */
    void run(Consumer<String> tell) {
        List<Task> missing = new ArrayList<>(tasks.stream().filter(task -> !isDone(task)).toList());
        Collections.shuffle(missing, new Random(seed));
        Progress progress = new Progress(missing.size(), tell);
        ExecutorService runners = Executors.newFixedThreadPool(free.size());
        try {
            List<Future<?>> running = new ArrayList<>();
            missing.forEach(task -> running.add(runners.submit(() -> run(task, progress))));
            for (Future<?> one : running) {
                one.get();
            }
        } catch (ExecutionException broken) {
            throw new IllegalStateException(broken.getCause().getMessage(), broken.getCause());
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", stop);
        } finally {
            runners.shutdownNow();
        }
    }

    private boolean isDone(Task task) {
        return task.settings().stream().allMatch(setting -> of(task, setting).isPresent());
    }

    private void run(Task task, Progress progress) {
        MeasuringJava java = free.remove();
        List<String> arguments = new ArrayList<>();
        arguments.addAll(List.of(task.problem(), task.engine(), task.patience().words()));
        arguments.addAll(task.names());
        try {
            String classPath = System.getProperty("java.class.path");
            keep(task, java.run(classPath, ProblemProbe.class, arguments, ProblemProbe.MARK));
        } catch (IllegalStateException broken) {
            throw new IllegalStateException(
                    task.problem() + " by " + task.engine() + " " + broken.getMessage(), broken);
        } finally {
            free.add(java);
        }
        synchronized (progress) {
            progress.done();
        }
    }

    private synchronized void keep(Task task, List<String> lines) {
        for (int i = 0; i < task.settings().size(); i++) {
            kept.add(name(task, task.settings().get(i)), lines.get(i));
        }
    }

    /** Everything that was asked for and found, in the order of engines and settings. */
    List<Point> points() {
        List<Point> points = new ArrayList<>();
        for (Task task : tasks) {
            for (Setting setting : task.settings()) {
                of(task, setting).ifPresent(found -> points.add(point(task, setting, found)));
            }
        }
        return points;
    }

    private Optional<Finding> of(Task task, Setting setting) {
        return kept.of(name(task, setting)).map(Finding::parse);
    }

    private static String name(Task task, Setting setting) {
        return String.join(
                " | ", task.problem(), task.engine(), setting.name(), task.patience().words());
    }

    private static Point point(Task task, Setting setting, Finding found) {
        return new Point(
                task.problem(),
                task.engine(),
                setting,
                found.errors(),
                found.steps(),
                found.work(),
                found.timing());
    }
}
