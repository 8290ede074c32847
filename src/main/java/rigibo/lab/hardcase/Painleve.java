package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * A rod of 2 m at tan θ = 2 slides on its lower end at 5 m/s, pushed rather than drawn. With the
 * lever r of that end, m = 1 and I = l²/3, the end stays on the floor where N(1 + rx(rx − μ·ry)/I)
 * = g + ry·ω², and ω′ = N(rx − μ·ry)/I, x″ = μN, y″ = N − g. Truth: at μ = 1.2, below 4/3, the
 * bracket is positive and the motion is that of this equation, integrated here by Runge and Kutta.
 * At μ = 2 it is negative (Painlevé, 1895): no force solves it, and all that is asked is what every
 * case is.
 */
final class Painleve implements Scenes {

    private static final double HALF_LENGTH = 1;
    private static final double THICKNESS = 1e-3;
    private static final double SPEED = 5;
    private static final double START = Math.atan(2);
    private static final double STEP = 1.0 / 960;
    private static final double HORIZON = 0.02;

    /** Steps of the reference per step of the pool: its error is far below 1e-9. */
    private static final int FINER = 20;

    private static final double INERTIA =
            (4 * HALF_LENGTH * HALF_LENGTH + THICKNESS * THICKNESS) / 12;

    @Override
    public void run(Trial trial) {
        trial.variant("regular");
        regular(trial, 1.2);
        trial.variant("paradox");
        WatchedPool pool = trial.earth();
        place(pool, 2);
        pool.run(2);
    }

    private static RigidBody place(WatchedPool pool, double friction) {
        pool.add(Earth.floor(friction, 0));
        return pool.add(
                Solid.box(2 * HALF_LENGTH, THICKNESS, friction, 0)
                        .at(0, -leverY(START))
                        .angle(START)
                        .velocity(-SPEED, 0)
                        .mass(1));
    }

    private static void regular(Trial trial, double friction) {
        WatchedPool pool = trial.earth();
        RigidBody rod = place(pool, friction);
        double[] truth = {START, 0, 0, -SPEED};
        long steps = Math.round(HORIZON / STEP);
        for (int i = 0; i < steps; i++) {
            pool.step(STEP);
            for (int j = 0; j < FINER; j++) {
                truth = rungeKutta(truth, STEP / FINER, friction);
            }
            trial.measure("angle", Math.abs(rod.angle() - truth[0]), "rad", 1e-3);
            trial.measure("place", Math.abs(rod.x() - truth[2]), "m", 1e-3);
        }
        double turned = truth[1];
        double spin = Math.abs(rod.angularVelocity() / turned - 1);
        trial.report("spin in the end", spin, "of truth");
    }

    private static double leverX(double angle) {
        return -HALF_LENGTH * Math.cos(angle) + THICKNESS / 2 * Math.sin(angle);
    }

    private static double leverY(double angle) {
        return -HALF_LENGTH * Math.sin(angle) - THICKNESS / 2 * Math.cos(angle);
    }

    /** Rates of angle, spin, x and velocity. */
    private static double[] rates(double[] state, double friction) {
        double rx = leverX(state[0]);
        double ry = leverY(state[0]);
        double turning = (rx - friction * ry) / INERTIA;
        double force = (Trial.GRAVITY + ry * state[1] * state[1]) / (1 + rx * turning);
        return new double[] {state[1], force * turning, state[3], friction * force};
    }

    private static double[] rungeKutta(double[] state, double h, double friction) {
        double[] k1 = rates(state, friction);
        double[] k2 = rates(moved(state, k1, h / 2), friction);
        double[] k3 = rates(moved(state, k2, h / 2), friction);
        double[] k4 = rates(moved(state, k3, h), friction);
        double[] next = new double[state.length];
        for (int i = 0; i < next.length; i++) {
            next[i] = state[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        return next;
    }

    private static double[] moved(double[] state, double[] rates, double h) {
        double[] next = new double[state.length];
        for (int i = 0; i < next.length; i++) {
            next[i] = state[i] + h * rates[i];
        }
        return next;
    }
}
