package rigibo.lab.problem;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.List;
import java.util.SplittableRandom;

/**
 * 36 smooth discs fall into a trough and come to rest. Final places have no known truth, but discs
 * are rigid, so none overlaps another or a wall. The error is the deepest overlap of a disc with a
 * neighbour or wall, averaged over discs and the last half second. The phases are heaps from other
 * seeds.
 */
final class DiscHeap {

    private static final int SIDE = 6;
    private static final int DISCS = SIDE * SIDE;
    private static final double RADIUS = 0.5;
    private static final double SECONDS = 6;
    private static final double WATCHED = 0.5;

    /** Gaps between the discs of a row, m, so that rows sink into each other. */
    private static final double PLAY = 0.4;

    private static final double WIDTH = SIDE * 2 * RADIUS + PLAY;
    private static final double WALL = 1;
    private static final double TALL = 20;
    private static final long[] SEEDS = {36, 37};
    private static final Material SMOOTH = new Material(1, 0, 0);

    /** The error promised at EXACT: 2 L at rest in every case, for a disc of 1 m. */
    private static final double EQUAL_BELOW = 2e-3 / RADIUS;

    private DiscHeap() {}

    static Problem problem() {
        return new Problem(
                "R11",
                "a heap of 36 smooth discs",
                "mean overlap at rest / radius",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.SUBSTEPS, Line.ITERATIONS, Line.SOLVER, Line.CORRECTION),
                DiscHeap::set);
    }

    private static Trial set(Bench bench) {
        World[] worlds = new World[SEEDS.length];
        for (int i = 0; i < worlds.length; i++) {
            worlds[i] = heap(bench, new SplittableRandom(SEEDS[i]));
        }
        return () -> fall(bench, worlds);
    }

    private static World heap(Bench bench, SplittableRandom random) {
        World world =
                bench.world(
                        Effects.of(
                                new Gravity(0, -Earth.GRAVITY),
                                new Contacts(),
                                new ContinuousImpacts()));
        for (int i = 0; i < DISCS; i++) {
            double share = (i % SIDE + 0.5) / SIDE - 0.5;
            double x = WIDTH * share + PLAY / SIDE * (random.nextDouble() - 0.5);
            double y = 2 * RADIUS + 1.2 * (i / SIDE) + 0.1 * random.nextDouble();
            world.add(Solid.disc(RADIUS).at(x, y).material(SMOOTH));
        }
        world.add(Earth.floor(0, 0));
        for (int side = -1; side <= 1; side += 2) {
            world.add(
                    Solid.fixed(WALL, TALL)
                            .at(side * (WIDTH + WALL) / 2, TALL / 2)
                            .material(SMOOTH));
        }
        return world;
    }

    private static Errors fall(Bench bench, World[] worlds) {
        double[] mean = new double[worlds.length];
        double fastest = 0;
        double deepest = 0;
        for (int i = 0; i < worlds.length; i++) {
            int steps = bench.stepsIn(SECONDS);
            int watched = bench.stepsIn(WATCHED);
            for (int step = 1; step <= steps; step++) {
                bench.step(worlds[i]);
                for (int disc = 0; disc < DISCS && step > steps - watched; disc++) {
                    double depth = depth(worlds[i], disc);
                    if (!(depth < RADIUS)) {
                        return Errors.failed("disc " + disc + " is inside another body");
                    }
                    mean[i] += depth / RADIUS / (DISCS * watched);
                    deepest = Math.max(deepest, depth);
                }
            }
            fastest = Math.max(fastest, fastest(worlds[i]));
        }
        return Errors.of(Mean.of(mean))
                .with("deepest overlap, m", deepest)
                .with("fastest disc at the end, m/s", fastest);
    }

    /** The deepest overlap of a disc with a neighbour or wall, m; 0 if there is none. */
    static double depth(World world, int disc) {
        double x = world.x(disc);
        double y = world.y(disc);
        double deepest = Math.max(0, RADIUS - y);
        deepest = Math.max(deepest, Math.abs(x) + RADIUS - WIDTH / 2);
        for (int other = 0; other < DISCS; other++) {
            if (other != disc) {
                double distance = Math.hypot(world.x(other) - x, world.y(other) - y);
                deepest = Math.max(deepest, 2 * RADIUS - distance);
            }
        }
        return deepest;
    }

    private static double fastest(World world) {
        double most = 0;
        for (int disc = 0; disc < DISCS; disc++) {
            most = Math.max(most, Math.hypot(world.velocityX(disc), world.velocityY(disc)));
        }
        return most;
    }
}
