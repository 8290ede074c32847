package rigibo.lab.bench;

import rigibo.backend.Pool;
import rigibo.lab.bench.probe.BenchProbe;
import rigibo.lab.bench.probe.Sample;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.child.Progress;
import rigibo.lab.engine.MeasuredClasses;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Outline;

import java.util.List;
import java.util.function.Consumer;

/** Has every scene timed by every engine, each in a process of its own, one at a time. */
final class BenchLab {

    private static final String LOG = "runs.log";

    /** 22,000 bodies of an engine of objects, and what it makes garbage of in a step. */
    private static final int HEAP_MEGABYTES = 1024;

    private final List<Task> tasks;
    private final Class<?> process;
    private final Kept kept;
    private final MeasuringJava java = MeasuringJava.onLastCore(HEAP_MEGABYTES);

    /**
     * A bench.
     *
     * @param process main class of the processes; it is told {@link Task#arguments}
     */
    BenchLab(Inquiry inquiry, Class<?> process) {
        tasks = inquiry.tasks();
        this.process = process;
        String key =
                MeasuredClasses.key(
                        inquiry.engines(),
                        Pool.class,
                        World.class,
                        Outline.class,
                        BenchProbe.class);
        kept = new Kept(inquiry.out().resolve(LOG), key);
    }

    /** How processes are run, in words. */
    String method() {
        return java.words();
    }

    /**
     * Runs what is missing.
     *
     * @param tell is told how far it is
     * @throws IllegalStateException when a process breaks off, with what it said
     */
    void run(Consumer<String> tell) {
        List<Task> missing = tasks.stream().filter(task -> kept.of(task.name()).isEmpty()).toList();
        Progress progress = new Progress(missing.size(), tell);
        for (Task task : missing) {
            kept.add(task.name(), run(task));
            progress.done();
        }
    }

    private String run(Task task) {
        try {
            String classPath = System.getProperty("java.class.path");
            return java.run(classPath, process, task.arguments(), BenchProbe.MARK).get(0);
        } catch (IllegalStateException broken) {
            throw new IllegalStateException(
                    task.scene().name() + " by " + task.engine() + " " + broken.getMessage(),
                    broken);
        }
    }

    /** Everything that was asked for, in the order in which it is run. */
    List<Run> runs() {
        return tasks.stream()
                .map(
                        task ->
                                new Run(
                                        task.scene().name(),
                                        task.engine(),
                                        task.round(),
                                        Sample.parse(kept.of(task.name()).orElseThrow())))
                .toList();
    }
}
