package rigibo.lab.bench;

import rigibo.backend.Pool;
import rigibo.lab.bench.probe.BenchProbe;
import rigibo.lab.bench.probe.Sample;
import rigibo.lab.child.Fields;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.MeasuredClasses;
import rigibo.lab.engine.World;
import rigibo.lab.precision.Environment;
import rigibo.lab.report.MeasuredPart;
import rigibo.lab.report.Report;
import rigibo.lab.truth.Outline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Runs the bench and reports the results. */
public final class BenchStudy {

    private static final String LOG = "runs.log";

    /** Room for 22,000 bodies that are objects, and for the garbage of a step, MB. */
    private static final int HEAP_MEGABYTES = 1024;

    private BenchStudy() {}

    /**
     * Makes the runs that are missing.
     *
     * @param process main class of the processes that measure; its arguments are the names of a
     *     scene and of an engine, and a pace
     * @param environment of the runs; how processes are started is added to its flags
     * @param table to which every run is written, if there is one
     * @param page whose measured part is written anew, if there is one
     * @param tell is told how far the runs are
     * @return the report, for a terminal
     * @throws IllegalStateException when a run breaks off
     * @throws IOException when something cannot be written
     */
    public static List<String> make(
            Inquiry inquiry,
            Class<?> process,
            Environment environment,
            Optional<Path> table,
            Optional<Path> page,
            Consumer<String> tell)
            throws IOException {
        MeasuringJava java = MeasuringJava.onLastCore(HEAP_MEGABYTES);
        Kept kept = new Kept(inquiry.out().resolve(LOG), key(inquiry.engines()));
        List<Task> tasks = inquiry.tasks();
        kept.make(tasks, Task::name, task -> run(java, process, task), tell);
        Results results = new Results(tasks.stream().map(task -> found(kept, task)).toList());
        Report report = BenchReport.of(inquiry, results);
        if (table.isPresent()) {
            Files.write(table.get(), BenchCsv.lines(results.runs()));
        }
        if (page.isPresent()) {
            MeasuredPart.write(
                    page.get(), report.markdown(environment.withFlags(java.words()).provenance()));
        }
        return report.text();
    }

    private static String key(List<Engine> engines) {
        return MeasuredClasses.key(
                engines, Pool.class, World.class, Outline.class, BenchProbe.class);
    }

    private static String run(MeasuringJava java, Class<?> process, Task task) {
        try {
            return java.run(process, task.arguments(), BenchProbe.MARK);
        } catch (IllegalStateException broken) {
            throw new IllegalStateException(
                    task.scene().name() + " by " + task.engine() + " " + broken.getMessage(),
                    broken);
        }
    }

    private static Run found(Kept kept, Task task) {
        Sample sample = Fields.parse(Sample.class, kept.of(task.name()).orElseThrow());
        return new Run(task.scene().name(), task.engine(), task.round(), sample);
    }
}
