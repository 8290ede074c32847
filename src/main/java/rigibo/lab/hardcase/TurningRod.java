package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

/**
 * A rod of 2 × 0.2 at (½, 0) and −40° turns by 80° in one step; the corner (0, ¼) of a plate is in
 * its way. Truth: in the rod's frame the corner is at the height ½·sin θ + ¼·cos θ, which meets the
 * lower face at −0.1 for θ = −(atan ½ + asin(0.1/√0.3125)) = −0.6435. Smooth and elastic, with the
 * lever rn = r × n, the impact gives ω′ = ω(1 − 2rn²/(I/m + rn²)); the time of the impact follows
 * from the final angle.
 */
final class TurningRod implements Scenes {

    private static final double START = Math.toRadians(-40);
    private static final double SPIN = Math.toRadians(80) / Trial.DT;
    private static final double TOUCH = -(Math.atan(0.5) + Math.asin(0.1 / Math.sqrt(0.3125)));
    private static final double INERTIA_PER_MASS = (2 * 2 + 0.2 * 0.2) / 12;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.space();
        pool.add(Solid.fixed(10, 0.5, 0, 1).at(-5, 0));
        RigidBody rod = pool.add(Solid.box(2, 0.2, 0, 1).at(0.5, 0).angle(START).spin(SPIN));
        pool.step();
        // The corner relative to the rod's centre, and the lower face's inward normal.
        double lever = -0.5 * Math.cos(TOUCH) + 0.25 * Math.sin(TOUCH);
        double square = lever * lever;
        double after = SPIN * (1 - 2 * square / (INERTIA_PER_MASS + square));
        double spin = rod.angularVelocity();
        trial.measure("spin", Math.abs(spin - after) / SPIN, "of w", 1e-6, 1e-2);
        double struck = (rod.angle() - START - spin * Trial.DT) / (SPIN - spin);
        double angle = START + SPIN * struck;
        trial.measure("angle of touch", Math.abs(angle - TOUCH), "rad", 1e-6, 1e-3);
    }
}
