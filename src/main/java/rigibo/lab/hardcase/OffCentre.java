package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Truth: equal smooth discs exchange the components along the normal. With r = ½ and the impact
 * parameter ½ the normal stands at sin α = ½, 30°: the struck one leaves along it with v·cos 30° =
 * 8.660, the other across it with v·sin 30° = 5, at 90° to each other.
 */
final class OffCentre implements Scenes {

    private static final double SPEED = 10;
    private static final double NORMAL = Math.PI / 6;
    private static final double DEGREE = Math.PI / 180;
    private static final int PHASES = 5;

    @Override
    public void run(Trial trial) {
        for (int phase = 0; phase < PHASES; phase++) {
            trial.variant("phase " + phase);
            WatchedPool pool = trial.space();
            BodyDefinition disc = Solid.disc(0.5, 0, 1);
            double start = -Math.cos(NORMAL) - SPEED * (6 + (phase + 0.5) / PHASES) * Trial.DT;
            RigidBody cue = pool.add(disc.at(start, 0).velocity(SPEED, 0));
            RigidBody struck = pool.add(disc.at(0, 0.5));
            pool.run(12 * Trial.DT);
            double along = StrictMath.atan2(struck.velocityY(), struck.velocityX());
            double across = StrictMath.atan2(cue.velocityY(), cue.velocityX());
            trial.measure("angle along", Math.abs(along - NORMAL), "rad", 1e-6, DEGREE);
            double right = Math.abs(along - across - Math.PI / 2);
            trial.measure("right angle", right, "rad", 1e-6, DEGREE);
            double speed = Math.hypot(struck.velocityX(), struck.velocityY());
            double off = Math.abs(speed - SPEED * Math.cos(NORMAL)) / SPEED;
            trial.measure("speed along", off, "of v", 1e-6, 1e-2);
        }
    }
}
