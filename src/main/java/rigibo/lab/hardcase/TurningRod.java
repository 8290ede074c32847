package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/**
 * A rod of 2 × 0.2 at (½, 0) and −40° turns by 80° in one step; the corner (0, ¼) of a plate is in
 * its way. Truth: in the rod's frame the corner is at height ½·sin θ + ¼·cos θ, which meets the
 * lower face at −0.1 for θ = −(atan ½ + asin(0.1/√0.3125)) = −0.6435. Smooth and elastic, the lever
 * rn = r × n gives ω′ = ω(1 − 2rn²/(I/m + rn²)), and the angle at the end tells when the rod was
 * struck.
 */
final class TurningRod implements HardCase {

    private static final double START = Math.toRadians(-40);
    private static final double SPIN = Math.toRadians(80) / Trial.DT;
    private static final double TOUCH = -(Math.atan(0.5) + Math.asin(0.1 / Math.sqrt(0.3125)));
    private static final double INERTIA_PER_MASS = (2 * 2 + 0.2 * 0.2) / 12;

    @Override
    public String row() {
        return "42";
    }

    @Override
    public String title() {
        return "a rod that only turns is stopped by a corner in its way";
    }

    /** DRAFT leaves impacts to the one solve of a pile that a step has. */
    @Override
    public Preset limitedFrom() {
        return Preset.GAME;
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.space());
        pool.add(
                BodyDefinition.fixed(Polygon.box(10, 0.5))
                        .at(-5, 0)
                        .material(Surroundings.matter(0, 1)));
        RigidBody rod =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(2, 0.2))
                                .at(0.5, 0)
                                .angle(START)
                                .spin(SPIN)
                                .material(Surroundings.matter(0, 1)));
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
