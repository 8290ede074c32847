package rigibo.lab.bench.workers;

import com.sun.management.OperatingSystemMXBean;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.lab.bench.scene.BenchScene;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;
import rigibo.lab.report.Report;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/**
 * Runs each step of a scene in pools with different numbers of workers in turn and times it by the
 * wall clock, which is what a player waits for. The time of rehearsed workers is computed: the
 * longest path of the work.
 *
 * @param scenes in the order of the report
 * @param crews the workers that make the steps; the others are compared with the first
 * @param steps of each scene
 * @param runs number of runs whose median is the time of a step, after an untimed one
 */
public record WorkersBench(List<BenchScene> scenes, List<Crew> crews, int steps, int runs) {

    private static final double DT = 1.0 / 60;
    private static final OperatingSystemMXBean SYSTEM =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    /** A pool, and what its scene needs to continue. */
    private record Going(Pool pool, World world, Scene scene) {

        static Going of(BenchScene scene, Crew crew) {
            Scene built = scene.scene().get();
            Pool pool = new Pool(built.effects(), Accuracy.GAME);
            crew.hireFor(pool);
            World world = RigiBoEngine.world(pool);
            built.build(world);
            return new Going(pool, world, built);
        }
    }

    /**
     * Times all scenes.
     *
     * @param tell is told how far it is
     */
    public Report run(Consumer<String> tell) {
        List<WorkersCourse> courses = new ArrayList<>();
        for (BenchScene scene : scenes) {
            List<WorkersCourse> found =
                    crews.stream()
                            .map(crew -> new WorkersCourse(scene, crew, steps, runs))
                            .toList();
            for (int run = -1; run < runs; run++) {
                tell.accept(scene.name() + ", run " + (run + 1) + " of " + runs);
                time(scene, run, found);
            }
            courses.addAll(found);
        }
        return new WorkersReport(courses, crews.get(0)).table();
    }

    /** The pools take turns at going first, since the first one finds a colder cache. */
    private void time(BenchScene scene, int run, List<WorkersCourse> courses) {
        Going[] going =
                courses.stream()
                        .map(course -> Going.of(scene, course.crew()))
                        .toArray(Going[]::new);
        long[] hashes = new long[going.length];
        for (int step = 0; step < steps; step++) {
            for (int i = 0; i < going.length; i++) {
                int turn = (step + i) % going.length;
                Going one = going[turn];
                one.scene.driver().drive(one.world, step);
                long used = SYSTEM.getProcessCpuTime();
                long before = System.nanoTime();
                one.pool.step(DT);
                long after = System.nanoTime();
                if (run >= 0) {
                    double all = SYSTEM.getProcessCpuTime() - used;
                    long took = after - before - one.pool.report().spared();
                    courses.get(turn).note(run, step, took, all, one.pool.report());
                }
                hashes[turn] = one.pool.stateHash();
            }
            if (Arrays.stream(hashes).distinct().count() > 1) {
                throw new IllegalStateException(
                        scene.name() + ": other bits by other workers after step " + (step + 1));
            }
        }
        Arrays.stream(going).forEach(one -> one.pool.close());
    }
}
