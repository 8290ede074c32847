package rigibo.lab.bench.moving;

import rigibo.backend.Pool;
import rigibo.lab.bench.probe.BenchProbe;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.child.Fields;
import rigibo.lab.child.Kept;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.MeasuredClasses;
import rigibo.lab.engine.World;
import rigibo.lab.report.Report;
import rigibo.lab.truth.Outline;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Runs each moving scene in every contestant, each run in its own process.
 *
 * @param scenes in the order of the report
 * @param contestants in the order of the report
 * @param steps of each scene at most
 * @param runs number of runs by which each step is timed
 * @param out directory where results are kept
 */
public record MovingBench(
        List<BenchScene> scenes, List<Contestant> contestants, int steps, int runs, Path out) {

    private static final String LOG = "moving.log";
    private static final int HEAP_MEGABYTES = 512;

    /** Describes how processes are run. */
    public String method() {
        return java().words();
    }

    private static MeasuringJava java() {
        return MeasuringJava.onLastCore(HEAP_MEGABYTES);
    }

    /**
     * Makes the runs that are missing.
     *
     * @param tell is told how far it is
     * @return the results of all runs
     * @throws IllegalStateException when a process breaks off, with what it said
     */
    public Report run(Consumer<String> tell) {
        Kept kept = new Kept(out.resolve(LOG), key());
        List<MovingTask> tasks = tasks();
        kept.make(tasks, MovingTask::name, MovingBench::run, tell);
        return report(tasks, kept);
    }

    private List<MovingTask> tasks() {
        List<MovingTask> tasks = new ArrayList<>();
        for (BenchScene scene : scenes) {
            int bodies = scene.scene().get().fingerprint();
            for (Contestant contestant : contestants) {
                tasks.add(new MovingTask(scene, bodies, contestant, steps, runs));
            }
        }
        return tasks;
    }

    private static String run(MovingTask task) {
        return java().run(MovingProbe.class, task.arguments(), MovingProbe.MARK);
    }

    private Report report(List<MovingTask> tasks, Kept kept) {
        Map<BenchScene, Map<Contestant, Course>> courses = new LinkedHashMap<>();
        for (MovingTask task : tasks) {
            courses.computeIfAbsent(task.scene(), scene -> new LinkedHashMap<>())
                    .put(
                            task.contestant(),
                            Fields.parse(Course.class, kept.of(task.name()).orElseThrow()));
        }
        List<Report.Passage> sections = new ArrayList<>();
        courses.forEach(
                (scene, found) -> {
                    String title = scene.name() + ": " + scene.what();
                    sections.add(new MovingSection(title, found, steps).passage());
                });
        return new Report("", sections);
    }

    /** A key of all classes that influence the results, those of the other engines included. */
    private String key() {
        List<Engine> engines =
                contestants.stream()
                        .map(Contestant::engine)
                        .distinct()
                        .map(Engines::named)
                        .toList();
        return MeasuredClasses.key(
                engines,
                Pool.class,
                World.class,
                Outline.class,
                BenchProbe.class,
                MovingProbe.class);
    }
}
