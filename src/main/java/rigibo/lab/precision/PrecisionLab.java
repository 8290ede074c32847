package rigibo.lab.precision;

import rigibo.backend.Pool;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.child.Progress;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.MeasuredClasses;
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

/** Runs every problem in every engine at every setting that is asked for. */
final class PrecisionLab {

    private static final String LOG = "points.log";

    private final List<Exam> exams;
    private final Kept kept;
    private final long seed;
    private final BlockingQueue<MeasuringJava> free;

    PrecisionLab(Inquiry inquiry) {
        List<Engine> engines = Engines.all();
        exams = inquiry.exams(engines);
        seed = inquiry.seed();
        String key = MeasuredClasses.key(engines, Pool.class, Problem.class, ProblemProbe.class);
        kept = new Kept(inquiry.out().resolve(LOG), key);
        free =
                new LinkedBlockingQueue<>(
                        inquiry.extent() == Extent.QUICK
                                ? MeasuringJava.onEveryCore()
                                : List.of(MeasuringJava.onLastCore()));
    }

    /** The log of results. */
    Kept kept() {
        return kept;
    }

    /** Describes how processes are run. */
    String method() {
        return free.element().words();
    }

    /**
     * Makes the missing runs.
     *
     * @param tell is told how far it is
     * @throws IllegalStateException when a process breaks off, with what it said
     */
    void run(Consumer<String> tell) {
        List<Exam> missing = missing();
        Collections.shuffle(missing, new Random(seed));
        Progress progress = new Progress(missing.size(), tell);
        ExecutorService runners = Executors.newFixedThreadPool(free.size());
        try {
            List<Future<?>> running = new ArrayList<>();
            missing.forEach(exam -> running.add(runners.submit(() -> run(exam, progress))));
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

    private List<Exam> missing() {
        return exams.stream()
                .filter(exam -> !isDone(exam))
                .collect(Collectors.toCollection(ArrayList::new));
    }

    private boolean isDone(Exam exam) {
        return exam.measured().stream().allMatch(setting -> of(exam, setting).isPresent());
    }

    private void run(Exam exam, Progress progress) {
        MeasuringJava java = free.remove();
        List<String> arguments = new ArrayList<>();
        arguments.addAll(List.of(exam.problem(), exam.engine().name(), exam.patience().words()));
        exam.measured().forEach(setting -> arguments.add(setting.name()));
        try {
            String classPath = System.getProperty("java.class.path");
            keep(exam, java.run(classPath, ProblemProbe.class, arguments, ProblemProbe.MARK));
        } catch (IllegalStateException broken) {
            throw new IllegalStateException(
                    exam.problem() + " by " + exam.engine().name() + " " + broken.getMessage(),
                    broken);
        } finally {
            free.add(java);
        }
        synchronized (progress) {
            progress.done();
        }
    }

    private synchronized void keep(Exam exam, List<String> lines) {
        for (int i = 0; i < exam.measured().size(); i++) {
            kept.add(name(exam, exam.measured().get(i)), lines.get(i));
        }
    }

    /** The results of all settings that were asked for, in the order of engines and settings. */
    List<Point> points() {
        List<Point> points = new ArrayList<>();
        for (Exam exam : exams) {
            for (Setting setting : exam.settings()) {
                of(exam, exam.engine().standsFor(setting))
                        .ifPresent(found -> points.add(point(exam, setting, found)));
            }
        }
        return points;
    }

    private Optional<Finding> of(Exam exam, Setting setting) {
        return kept.of(name(exam, setting)).map(Finding::parse);
    }

    private static String name(Exam exam, Setting setting) {
        return String.join(
                " | ",
                exam.problem(),
                exam.engine().name(),
                setting.name(),
                exam.patience().words());
    }

    private static Point point(Exam exam, Setting setting, Finding found) {
        return new Point(
                exam.problem(),
                exam.engine().name(),
                setting,
                found.errors(),
                found.steps(),
                found.work(),
                found.timing());
    }
}
