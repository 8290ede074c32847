package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * One disc meets two that touch, all equal, smooth and elastic. Truth (Johann Bernoulli): both
 * impacts happen at once, with J along ±30° each. The normal velocity reverses, v·cos − 2J·cos² − J
 * = −v·cos, so J = (2√3/5)v per mass and v1 = v − 2J·cos 30° = −v/5. A gap δ left open at the
 * impact turns the normals by 0.58·δ and changes the velocities by 0.3·δ of v: GAME, where δ is up
 * to 0.1 mm, cannot be held to 1e-9.
 */
final class Bernoulli implements Scenes {

    private static final double SPEED = 10;
    private static final int PHASES = 5;

    @Override
    public void run(Trial trial) {
        for (int phase = 0; phase < PHASES; phase++) {
            trial.variant("phase " + phase);
            WatchedPool pool = trial.space();
            BodyDefinition disc = Solid.disc(0.5, 0, 1);
            double way = SPEED * (4 + (phase + 0.5) / PHASES) * Trial.DT;
            RigidBody cue = pool.add(disc.at(-Math.sqrt(0.75) - way, 0).velocity(SPEED, 0));
            RigidBody upper = pool.add(disc.at(0, 0.5));
            RigidBody lower = pool.add(disc.at(0, -0.5));
            pool.run(8 * Trial.DT);
            double impulse = 2 * Math.sqrt(3) / 5 * SPEED;
            double cueOff = Math.abs(cue.velocityX() + SPEED / 5) / SPEED;
            double speed = Math.hypot(upper.velocityX(), upper.velocityY());
            double upperOff = Math.abs(speed - impulse) / SPEED;
            trial.measure("velocities", Math.max(cueOff, upperOff), "of v", 1e-9, 1e-4);
            double asymmetry =
                    Math.hypot(
                            upper.velocityX() - lower.velocityX(),
                            upper.velocityY() + lower.velocityY());
            trial.measure("asymmetry", asymmetry / SPEED, "of v", 1e-9);
        }
    }
}
