package rigibo.fuzz;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.fuzz.chance.Chance;
import rigibo.fuzz.judge.Tally;
import rigibo.fuzz.judge.Watch;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * Runs one pool for hours, in which bodies come, pile up and go. After each lap the pool is emptied
 * and must be as after the first laps: its snapshot is no longer, the heap no larger, and no pair
 * is left.
 */
final class SoakSubject implements Subject {

    private static final double DT = 1.0 / 60;

    /** Ten seconds of simulated time. */
    private static final int STEPS_PER_LAP = 600;

    private static final int STEPS_BETWEEN_BODIES = 6;
    private static final int MOST_BODIES = 60;

    /** Half the width of the tray, m. */
    private static final double HALF = 5;

    /** The first laps, in which columns, caches and compiled code grow to their final size. */
    private static final int WARM_UP = 20;

    /** The variation of the heap that is allowed, B, for what the JVM compiles and profiles. */
    private static final long MOST_GROWTH = 4 << 20;

    private final Tally tally;
    private final Watch watch;
    private final Pool pool =
            new Pool(
                    Effects.of(
                            new Gravity(0, -9.81),
                            new Contacts(),
                            new Rotation(),
                            new Friction(),
                            new Restitution(),
                            new RollingResistance(),
                            new Thrust(),
                            new ContinuousImpacts(),
                            new Sleep()),
                    Accuracy.GAME);
    private final Deque<RigidBody> loose = new ArrayDeque<>();
    private long mostBytes;
    private long mostHeap;

    SoakSubject(Tally tally, Watch watch) {
        this.tally = tally;
        this.watch = watch;
        pool.add(BodyDefinition.fixed(Polygon.box(2 * HALF + 2, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 40)).at(-HALF - 0.5, 20));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 40)).at(HALF + 0.5, 20));
    }

    @Override
    public String title() {
        return "soak";
    }

    @Override
    public String again(long seed, long index) {
        return "--only soak --seed " + seed;
    }

    @Override
    public Optional<String> tried(long seed, long index) {
        Chance chance = Chance.of(seed, index);
        for (int i = 0; i < STEPS_PER_LAP; i++) {
            watch.begins("step " + i + " of lap " + index);
            if (i % STEPS_BETWEEN_BODIES == 0) {
                exchange(chance);
            }
            step();
        }
        empty();
        step();
        return wrongAfter(index).map(words -> "after " + pool.time() + " s: " + words);
    }

    private void step() {
        pool.step(DT);
        pool.contactEvents();
        tally.count(Tally.Of.STEPS);
    }

    private void exchange(Chance chance) {
        if (loose.size() >= MOST_BODIES) {
            pool.remove(loose.removeFirst());
        }
        loose.add(
                pool.add(
                        BodyDefinition.dynamic(shape(chance))
                                .at(chance.between(-HALF + 1, HALF - 1), 12)
                                .angle(chance.between(-3, 3))
                                .velocity(chance.between(-5, 5), chance.between(-9, 2))
                                .material(
                                        new Material(
                                                chance.ofAnySize(0.3, 3),
                                                chance.between(0, 1),
                                                chance.between(0, 0.9),
                                                chance.between(0, 0.01),
                                                0,
                                                0))));
        RigidBody some = chance.oneOf(new ArrayList<>(loose));
        some.applyForce(0, 10 * some.mass(), some.x(), some.y());
        List<RigidBody> found = new ArrayList<>();
        pool.overlapping(new Aabb(-1, 0, 1, 2), found::add);
        pool.rayCast(-HALF, 1, HALF, 1);
    }

    private static Shape shape(Chance chance) {
        double size = chance.between(0.2, 0.6);
        return switch (chance.whole(0, 2)) {
            case 0 -> new Circle(size / 2);
            case 1 -> Polygon.box(size, chance.between(0.2, 0.6));
            default -> Polygon.regular(chance.whole(3, 9), size / 2);
        };
    }

    private void empty() {
        loose.forEach(pool::remove);
        loose.clear();
    }

    private Optional<String> wrongAfter(long lap) {
        if (pool.report().pairs() != 0 || pool.report().rows() != 0) {
            return Optional.of("the emptied pool has " + pool.report().pairs() + " pairs");
        }
        long bytes = pool.snapshot().length;
        long heap = heap();
        if (lap < WARM_UP) {
            mostBytes = Math.max(mostBytes, bytes);
            mostHeap = Math.max(mostHeap, heap);
            return Optional.empty();
        }
        if (bytes > mostBytes) {
            return Optional.of("a snapshot has " + bytes + " B, had " + mostBytes);
        }
        return heap > mostHeap + MOST_GROWTH
                ? Optional.of("the heap holds " + heap + " B, held " + mostHeap)
                : Optional.empty();
    }

    /** The used heap after a garbage collection, B. */
    private static long heap() {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return runtime.totalMemory() - runtime.freeMemory();
    }
}
