package rigibo.lab.problem;

import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * Planets on orbits of the eccentricity ε = ½ around a sun. With s = G·M and the semi-major axis a
 * the energy per mass stays v²/2 − s/r = −s/2a (vis viva), so a planet starts at its periapsis, r =
 * a(1 − ε), with v² = s(2/r − 1/a). The Laplace–Runge–Lenz vector (v_y·L/s − x/r, −v_x·L/s − y/r),
 * L = x· v_y − y·v_x, stays too and points to the periapsis, here to the right. The axes differ, so
 * that steps fall on different places of the orbits.
 */
final class Orbit {

    private static final double SECONDS = 100;
    private static final double ECCENTRICITY = 0.5;

    /** s, m³/s²: a planet with the semi-major axis 1 m has a period of a second. */
    private static final double STRENGTH = 4 * Math.PI * Math.PI;

    /** The phases: semi-major axes, m. */
    private static final double[] HALF_AXES = {0.87, 0.94, 1.03, 1.12, 1.19};

    /** The error promised at EXACT, row origin/fields: an orbit for a hundred turns. */
    private static final double EQUAL_BELOW = 1e-7;

    private Orbit() {}

    static Problem problem() {
        return new Problem(
                "R4",
                "an eccentric orbit for 100 turns",
                "largest change of energy / energy",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.STEP_EULER, Line.STEP_VERLET, Line.STEP_RK4, Line.SUBSTEPS),
                Orbit::set);
    }

    private static Trial set(Bench bench) {
        World world = bench.world(Effects.of(new CentralForce(0, 0, STRENGTH, -2)));
        for (double axis : HALF_AXES) {
            double nearest = axis * (1 - ECCENTRICITY);
            double speed = Math.sqrt(STRENGTH * (2 / nearest - 1 / axis));
            world.add(Solid.disc(0.01).at(nearest, 0).velocity(0, speed));
        }
        return () -> turn(bench, world);
    }

    private static Errors turn(Bench bench, World world) {
        int count = HALF_AXES.length;
        double[] gain = new double[count];
        for (int step = 0; step < bench.stepsIn(SECONDS); step++) {
            bench.step(world);
            for (int i = 0; i < count; i++) {
                double share = energy(world, i) / (-STRENGTH / (2 * HALF_AXES[i]));
                gain[i] = Math.max(gain[i], Math.abs(share - 1));
            }
        }
        double[] drift = new double[count];
        for (int i = 0; i < count; i++) {
            drift[i] = Math.abs(apsis(world, i));
        }
        return Errors.of(Mean.of(gain)).with("drift of the apsis, rad", Mean.of(drift));
    }

    private static double energy(World world, int planet) {
        double v = Math.hypot(world.velocityX(planet), world.velocityY(planet));
        return v * v / 2 - STRENGTH / Math.hypot(world.x(planet), world.y(planet));
    }

    /** The angle from the first periapsis to the present one, rad. */
    private static double apsis(World world, int planet) {
        double x = world.x(planet);
        double y = world.y(planet);
        double vx = world.velocityX(planet);
        double vy = world.velocityY(planet);
        double momentum = (x * vy - y * vx) / STRENGTH;
        double r = Math.hypot(x, y);
        return Math.atan2(-vx * momentum - y / r, vy * momentum - x / r);
    }
}
