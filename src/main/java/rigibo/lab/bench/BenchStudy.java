package rigibo.lab.bench;

import rigibo.backend.Pool;
import rigibo.lab.bench.probe.BenchProbe;
import rigibo.lab.bench.probe.Sample;
import rigibo.lab.child.Fields;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
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

    /**
     * Room for 22,000 bodies of an engine that makes an object of each, and for the garbage of a
     * step.
     */
    private static final int HEAP_MEGABYTES = 1024;

    private final Inquiry inquiry;
    private final Class<?> process;
    private final Kept kept;
    private final MeasuringJava java = MeasuringJava.onLastCore(HEAP_MEGABYTES);
    private final Environment environment;

    /**
     * A study.
     *
     * @param process main class of the processes that measure; it is told the names of a scene and
     *     of an engine, and a pace in its own words
     * @param environment of the runs; how processes are started is added to its flags
     */
    public BenchStudy(Inquiry inquiry, Class<?> process, Environment environment) {
        this.inquiry = inquiry;
        this.environment = environment;
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

    /**
     * Makes the runs that are missing.
     *
     * @param table to which every run is written, if one is
     * @param page whose measured part is written anew, if one is
     * @param tell is told how far the runs are
     * @return what was found, for a terminal
     * @throws IllegalStateException when a run breaks off
     * @throws IOException when something cannot be written
     */
    public List<String> make(Optional<Path> table, Optional<Path> page, Consumer<String> tell)
            throws IOException {
        List<Task> tasks = inquiry.tasks();
        kept.make(tasks, Task::name, this::run, tell);
        Results results = new Results(tasks.stream().map(this::found).toList());
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

    private String run(Task task) {
        try {
            return java.run(process, task.arguments(), BenchProbe.MARK);
        } catch (IllegalStateException broken) {
            throw new IllegalStateException(
                    task.scene().name() + " by " + task.engine() + " " + broken.getMessage(),
                    broken);
        }
    }

    private Run found(Task task) {
        Sample sample = Fields.parse(Sample.class, kept.of(task.name()).orElseThrow());
        return new Run(task.scene().name(), task.engine(), task.round(), sample);
    }
}
