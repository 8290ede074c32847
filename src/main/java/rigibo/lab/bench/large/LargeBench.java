package rigibo.lab.bench.large;

import rigibo.backend.RigidBody;
import rigibo.lab.bench.probe.StepTimes;
import rigibo.lab.child.ThreadUse;
import rigibo.lab.report.Report;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * Measures, in this process, what each body costs in very large worlds.
 *
 * @param sizes movable bodies of each world
 */
public record LargeBench(List<Integer> sizes) {

    /** Two sizes, one ten times the other, to show costs that grow faster than the world. */
    public static final List<Integer> SIZES = List.of(10_000, 100_000);

    private static final double DT = 1.0 / 60;

    /** The number of steps until the heaps sleep, and of the timed steps after them. */
    private static final int SETTLING = 120;

    private static final int TIMED = 60;

    /** The number of steps of a sleeping world that are timed as one. */
    private static final int ASLEEP = 2_000;

    /** The number of queries, and of bodies removed. */
    private static final int ASKED = 1_000;

    /**
     * Measures all worlds, after one run of the smallest for the compiler.
     *
     * @param tell is told how far it is
     */
    public Report run(Consumer<String> tell) {
        tell.accept("a world for the compiler");
        costs(sizes.stream().min(Integer::compare).orElseThrow());
        return LargeReport.of(
                sizes.stream()
                        .peek(size -> tell.accept("a world of " + size + " bodies"))
                        .map(LargeBench::costs)
                        .toList());
    }

    private static LargeCosts costs(int size) {
        long memory = memory();
        long begun = ThreadUse.nanos();
        LargeWorld world = LargeWorld.of(size);
        double add = (ThreadUse.nanos() - begun) / (double) size;
        double first = step(world);
        IntStream.range(0, SETTLING).forEach(i -> step(world));
        StepTimes times =
                new StepTimes(IntStream.range(0, TIMED).mapToDouble(i -> step(world)).toArray());
        double bytes = (memory() - memory) / (double) size;
        double ask = ask(world);
        begun = ThreadUse.nanos();
        int length = world.pool.snapshot().length;
        double snapshot = length > 0 ? ThreadUse.nanos() - begun : 0;
        double remove = remove(world);
        double asleep = asleep(size);
        return new LargeCosts(
                size,
                add,
                first,
                times.median(),
                times.max(),
                ask,
                snapshot,
                remove,
                asleep,
                bytes);
    }

    /** Processor time of a step, ns. */
    private static double step(LargeWorld world) {
        long begun = ThreadUse.nanos();
        world.pool.step(DT);
        return ThreadUse.nanos() - begun;
    }

    private static double asleep(int size) {
        LargeWorld world = LargeWorld.ofHeaps(size);
        for (int i = 0; i < SETTLING || world.bodies.get(0).isAwake(); i++) {
            world.pool.step(DT);
        }
        long begun = ThreadUse.nanos();
        for (int i = 0; i < ASLEEP; i++) {
            world.pool.step(DT);
        }
        return (ThreadUse.nanos() - begun) / (double) ASLEEP;
    }

    private static double ask(LargeWorld world) {
        long begun = ThreadUse.nanos();
        int found = 0;
        for (int i = 0; i < ASKED; i++) {
            RigidBody body = world.bodies.get(i * (world.bodies.size() / ASKED));
            found += world.pool.bodyAt(body.x(), body.y()).isPresent() ? 1 : 0;
        }
        double each = (ThreadUse.nanos() - begun) / (double) ASKED;
        if (found < ASKED) {
            throw new IllegalStateException("no body where there is one");
        }
        return each;
    }

    private static double remove(LargeWorld world) {
        long begun = ThreadUse.nanos();
        for (int i = 0; i < ASKED; i++) {
            world.pool.remove(world.bodies.get(i * (world.bodies.size() / ASKED)));
        }
        return (ThreadUse.nanos() - begun) / (double) ASKED;
    }

    /**
     * Bytes in use after garbage collection, twice: what the first one finds to be garbage, the
     * world before, may be in use until the second.
     */
    private static long memory() {
        System.gc();
        System.gc();
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }
}
