package rigibo.lab.problem;

import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Slope;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * Three motions that friction determines.
 *
 * <p>A box slides down a slope that is 10° steeper than μ holds: d = a·t²/2, a = g·(sin b − μ·cos
 * b).
 *
 * <p>A box slides to a stop on level ground: d = v²/2μg. It stops within a step, so several phases
 * are run, as for the next.
 *
 * <p>A disc that is thrown without spin slips until it rolls. It loses μg·t of its velocity, and
 * its rim gains μg·t·mr²/I = 2μg·t; the two are equal at T = v/3μg. Then it rolls on with 2v/3: d =
 * v·T − μg·T²/2 + (2v/3)·(t − T).
 */
final class SlideAndRoll {

    private static final double SECONDS = 2;
    private static final double FRICTION = 0.5;
    private static final double STEEPER = Math.toRadians(10);
    private static final double THICKNESS = 0.25;
    private static final double RADIUS = 0.25;

    /** Distance between bodies, m: more than the fastest moves. */
    private static final double DISTANCE = 20;

    /** The phases, m/s; all slide and slip for less than the seconds. */
    private static final double[] SPEEDS = {5.03, 5.71, 6.37, 6.89, 7.43, 8.11, 8.67, 9.29};

    private static final Slope SLOPE = new Slope(Math.atan(FRICTION) + STEEPER);
    private static final Material MATTER = new Material(1, FRICTION, 0);

    /** The error promised at EXACT, row 27: the distance of a box to its stop. */
    private static final double EQUAL_BELOW = 1e-5;

    private SlideAndRoll() {}

    static Problem problem() {
        return new Problem(
                "R8",
                "down a slope, to a stop, from slipping to rolling",
                "error of the distance / distance",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.SUBSTEPS),
                SlideAndRoll::set);
    }

    private static Trial set(Bench bench) {
        World slope = bench.world(Earth.effects());
        BodyDefinition box = Solid.box(1, THICKNESS).material(MATTER);
        slope.add(SLOPE.place(box, THICKNESS / 2));
        slope.add(SLOPE.plank(MATTER));
        World sliding = level(bench, box, THICKNESS / 2);
        BodyDefinition disc = Solid.disc(RADIUS).material(MATTER);
        World rolling = level(bench, disc, RADIUS);
        return () -> run(bench, slope, sliding, rolling);
    }

    private static World level(Bench bench, BodyDefinition body, double above) {
        World world = bench.world(Earth.effects());
        for (int i = 0; i < SPEEDS.length; i++) {
            world.add(body.at(start(i), above).velocity(SPEEDS[i], 0));
        }
        world.add(Earth.floor(FRICTION, 0));
        return world;
    }

    private static double start(int phase) {
        return DISTANCE * (phase - SPEEDS.length / 2);
    }

    private static Errors run(Bench bench, World slope, World sliding, World rolling) {
        double startX = slope.x(0);
        double startY = slope.y(0);
        int steps = bench.stepsIn(SECONDS);
        for (int step = 0; step < steps; step++) {
            bench.step(slope);
            bench.step(sliding);
            bench.step(rolling);
        }
        double time = steps * bench.step();
        double way = SLOPE.down(slope.x(0) - startX, slope.y(0) - startY);
        double down = Math.abs(way / downhill(time) - 1);
        double[] stop = new double[SPEEDS.length];
        double[] roll = new double[SPEEDS.length];
        for (int i = 0; i < SPEEDS.length; i++) {
            stop[i] = Math.abs((sliding.x(i) - start(i)) / stopping(SPEEDS[i]) - 1);
            roll[i] = Math.abs((rolling.x(i) - start(i)) / rolling(SPEEDS[i], time) - 1);
        }
        return Errors.of(Mean.of(down, Mean.of(stop), Mean.of(roll)))
                .with("slope, of the distance", down)
                .with("slide to a stop, of the distance", Mean.of(stop))
                .with("slip to roll, of the distance", Mean.of(roll));
    }

    /** Distance that a box slides down the slope, m. */
    static double downhill(double time) {
        double b = SLOPE.angle();
        return Earth.GRAVITY * (Math.sin(b) - FRICTION * Math.cos(b)) * time * time / 2;
    }

    /** Distance that a box slides on level ground, m. */
    static double stopping(double speed) {
        return speed * speed / (2 * FRICTION * Earth.GRAVITY);
    }

    /** Distance that a disc moves, slipping and then rolling, m. */
    static double rolling(double speed, double time) {
        double braking = FRICTION * Earth.GRAVITY;
        double slip = speed / (3 * braking);
        return speed * slip - braking * slip * slip / 2 + 2 * speed / 3 * (time - slip);
    }
}
