package rigibo.lab.problem;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * Stacks of N = 10 and 20 boxes of 1 m and 1 kg stand, so nothing accelerates. The support of box
 * k, counted from 0 at the bottom, carries N − k boxes: in a step of dt its impulse is λₖ = (N −
 * k)·m·g·dt. It is read at every step of the last half second, and the largest error counts.
 */
final class Stacks {

    private static final int[] COUNTS = {10, 20};
    private static final double SECONDS = 3;
    private static final double WEIGHED = 0.5;
    private static final double MASS = 1;

    /**
     * The gap between boxes at the start, m: some engines give polygons a skin of 1 cm and would
     * find boxes that touch overlapping.
     */
    private static final double GAP = 0.02;

    /** The error promised at EXACT, row 19: the impulse below a box; row 20 has it for stacks. */
    private static final double EQUAL_BELOW = 1e-6;

    private Stacks() {}

    static Problem problem() {
        return new Problem(
                "R9",
                "stacks of 10 and 20 boxes",
                "largest error of a contact's impulse / weight of the stack",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.SUBSTEPS, Line.SOLVER),
                Stacks::set);
    }

    private static Trial set(Bench bench) {
        World[] worlds = new World[COUNTS.length];
        for (int stack = 0; stack < COUNTS.length; stack++) {
            worlds[stack] = bench.world(Earth.effects());
            worlds[stack].add(Earth.floor(0.5, 0));
            for (int i = 0; i < COUNTS[stack]; i++) {
                worlds[stack].add(Solid.box(1, 1).at(0, i + 0.5 + GAP * (i + 1)).mass(MASS));
            }
        }
        return () -> stand(bench, worlds);
    }

    private static Errors stand(Bench bench, World[] worlds) {
        double[] load = new double[COUNTS.length];
        double overlap = 0;
        double lean = 0;
        for (int stack = 0; stack < COUNTS.length; stack++) {
            World world = worlds[stack];
            int weighed = bench.stepsIn(WEIGHED);
            for (int step = bench.stepsIn(SECONDS); step > weighed; step--) {
                bench.step(world);
            }
            world.watchImpulses();
            for (int step = 0; step < weighed; step++) {
                bench.step(world);
                load[stack] = Math.max(load[stack], load(bench, world, COUNTS[stack]));
            }
            for (int i = 1; i <= COUNTS[stack]; i++) {
                if (!(Math.abs(world.x(i)) < 0.5 && world.y(i) > i - 1)) {
                    return Errors.failed("the stack of " + COUNTS[stack] + " fell");
                }
                double below = i == 1 ? -0.5 : world.y(i - 1);
                overlap = Math.max(overlap, below + 1 - world.y(i));
                lean = Math.max(lean, Math.abs(world.x(i)));
            }
        }
        return Errors.of(Mean.of(load)).with("overlap, m", overlap).with("lean, m", lean);
    }

    private static double load(Bench bench, World world, int count) {
        double unit = MASS * Earth.GRAVITY * bench.step();
        double worst = 0;
        for (int i = 0; i < count; i++) {
            double impulse = world.normalImpulse(i, i + 1);
            worst = Math.max(worst, Math.abs(impulse / unit - (count - i)) / count);
        }
        return worst;
    }
}
