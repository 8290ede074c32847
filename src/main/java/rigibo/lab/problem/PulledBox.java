package rigibo.lab.problem;

import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Thrust;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * A box of M = 10 kg is pulled with F = 150 N over rough ground, and n = 25 discs of m = 1 kg roll
 * on it, like the balls in the rolling test of SimBenchmark (leggedrobotics.github.io/SimBenchmark,
 * 2018).
 *
 * <p>The ground brakes the box by f₁ = μ₁·(M + nm)·g, each disc by the friction f₂ that drives the
 * disc. A disc's centre accelerates by f₂/m and its lowest point, with I = mr²/2, by f₂/m + f₂·r²/I
 * = 3f₂/m; without slip that equals the box's (F − f₁ − n·f₂)/M. So f₂ = ((F − f₁)/M)/(3/m + n/M),
 * a_box = (F − f₁ − n·f₂)/M and a_disc = f₂/m, and nothing slips, as f₂ = 0.23 N is less than
 * μ₂·m·g. From rest all velocities are a·t; the error is the mean of their squared errors, over
 * steps and bodies.
 */
final class PulledBox {

    private static final double SECONDS = 4;
    private static final double BOX = 10;
    private static final double PULL = 150;
    private static final int DISCS = 25;
    private static final double DISC = 1;
    private static final double GROUND_FRICTION = 0.4;
    private static final double DISC_FRICTION = 0.8;

    private static final double LENGTH = 17;
    private static final double THICKNESS = 0.4;
    private static final double RADIUS = 0.2;
    private static final double DISTANCE = 0.5;

    /** Distance of the discs' middle to the right of the box's, m: they fall back by 3.7 m. */
    private static final double AHEAD = 1.8;

    private static final double GROUND_BRAKE =
            GROUND_FRICTION * (BOX + DISCS * DISC) * Earth.GRAVITY;
    private static final double DISC_BRAKE = (PULL - GROUND_BRAKE) / BOX / (3 / DISC + DISCS / BOX);

    /** Acceleration of the box to the right, m/s². */
    static final double BOX_GAINS = (PULL - GROUND_BRAKE - DISCS * DISC_BRAKE) / BOX;

    /** Acceleration of a disc to the right, m/s². */
    static final double DISC_GAINS = DISC_BRAKE / DISC;

    /** The error promised at EXACT, row 34: 1e-5 of a velocity, here of the box's at the end. */
    private static final double EQUAL_BELOW = Math.pow(1e-5 * BOX_GAINS * SECONDS, 2);

    private PulledBox() {}

    static Problem problem() {
        return new Problem(
                "R7",
                "25 discs rolling on a box that is pulled",
                "mean square error of the velocities, m²/s²",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.SUBSTEPS, Line.SOLVER),
                PulledBox::set);
    }

    /** Makes a box with the discs' friction, so that √(μ·μ) is theirs; the ground compensates. */
    private static Trial set(Bench bench) {
        World world = bench.world(Earth.effects().without(Restitution.class).with(new Thrust()));
        Material rough = new Material(1, DISC_FRICTION, 0);
        world.add(Solid.box(LENGTH, THICKNESS).at(0, THICKNESS / 2).mass(BOX).material(rough));
        for (int i = 0; i < DISCS; i++) {
            world.add(
                    Solid.disc(RADIUS)
                            .at(AHEAD + DISTANCE * (i - DISCS / 2), THICKNESS + RADIUS)
                            .mass(DISC)
                            .material(rough));
        }
        world.add(Earth.floor(GROUND_FRICTION * GROUND_FRICTION / DISC_FRICTION, 0));
        return () -> pull(bench, world);
    }

    private static Errors pull(Bench bench, World world) {
        double squares = 0;
        int steps = bench.stepsIn(SECONDS);
        for (int step = 1; step <= steps; step++) {
            world.push(0, PULL, 0);
            bench.step(world);
            double time = step * bench.step();
            squares += square(world, 0, BOX_GAINS * time);
            for (int disc = 1; disc <= DISCS; disc++) {
                squares += square(world, disc, DISC_GAINS * time);
            }
        }
        for (int disc = 1; disc <= DISCS; disc++) {
            if (world.y(disc) < THICKNESS) {
                return Errors.failed("disc " + disc + " left the box");
            }
        }
        return Errors.of(squares / (steps * (DISCS + 1)));
    }

    private static double square(World world, int body, double velocity) {
        double awayX = world.velocityX(body) - velocity;
        double awayY = world.velocityY(body);
        return awayX * awayX + awayY * awayY;
    }
}
