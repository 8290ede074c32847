package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Truth: a smooth impact with the lever rx gives j = (1 + e)mv/(1 + m·rx²/I), v′ = −v + j/m, ω′ =
 * rx·j/I. For a thin rod of 2 m at 30°, j = (1 + e)mv/(1 + 3cos²30°) = 2.3077 m, v′ = −2.6923, |ω′|
 * = 5.9956. The rod here is 1 mm thick and hits with its lower left corner, so its lever and
 * inertia are those of a box.
 */
final class RodEnd implements Scenes {

    private static final double LENGTH = 2;
    private static final double THICKNESS = 1e-3;
    private static final double ANGLE = Math.PI / 6;
    private static final double SPEED = 5;
    private static final double ELASTICITY = 0.5;
    private static final int PHASES = 5;

    @Override
    public void run(Trial trial) {
        double cos = Math.cos(ANGLE);
        double sin = Math.sin(ANGLE);
        double leverX = -cos * LENGTH / 2 + sin * THICKNESS / 2;
        double below = sin * LENGTH / 2 + cos * THICKNESS / 2;
        double inertiaPerMass = (LENGTH * LENGTH + THICKNESS * THICKNESS) / 12;
        double impulse = (1 + ELASTICITY) * SPEED / (1 + leverX * leverX / inertiaPerMass);
        for (int phase = 0; phase < PHASES; phase++) {
            trial.variant("phase " + phase);
            WatchedPool pool = trial.space();
            pool.add(Earth.floor(0, ELASTICITY));
            double fall = SPEED * (6 + (phase + 0.5) / PHASES) * Trial.DT;
            RigidBody rod =
                    pool.add(
                            Solid.box(LENGTH, THICKNESS, 0, ELASTICITY)
                                    .at(0, below + fall)
                                    .angle(ANGLE)
                                    .velocity(0, -SPEED));
            pool.run(7 * Trial.DT);
            double speed = rod.velocityY() - (impulse - SPEED);
            trial.measure("velocity", Math.abs(speed), "m/s", 1e-6, 1e-2);
            double spin = rod.angularVelocity() - leverX * impulse / inertiaPerMass;
            trial.measure("spin", Math.abs(spin), "rad/s", 1e-6, 1e-2);
        }
    }
}
