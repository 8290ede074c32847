package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Discs of 0.1 m at ±200 m/s, head on and with the impact parameter b = r. Truth: they touch when
 * their distance along the flight is 2r·cos α with sin α = b/2r, so 0° or 30°; smooth and elastic,
 * they exchange the components along the normal. The time of the impact follows from their later
 * places, since each moves at v before it and at v′ after it.
 */
final class BulletsMeet implements Scenes {

    private static final double RADIUS = 0.1;
    private static final double SPEED = 200;
    private static final int PHASES = 25;

    @Override
    public void run(Trial trial) {
        for (double parameter : new double[] {0, RADIUS}) {
            for (int phase = 0; phase < PHASES; phase++) {
                trial.variant("b " + parameter + ", phase " + phase);
                meet(trial, parameter, (2 + (phase + 0.5) / PHASES) * Trial.DT);
            }
        }
    }

    private static void meet(Trial trial, double parameter, double impact) {
        double sin = parameter / (2 * RADIUS);
        double cos = Math.sqrt(1 - sin * sin);
        double x = RADIUS * cos + SPEED * impact;
        WatchedPool pool = trial.space();
        BodyDefinition disc = Solid.disc(RADIUS, 0, 1);
        RigidBody left = pool.add(disc.at(-x, 0).velocity(SPEED, 0));
        RigidBody right = pool.add(disc.at(x, parameter).velocity(-SPEED, 0));
        pool.run(4 * Trial.DT);
        // The normal is (cos, sin); the closing speed along it is 2v·cos.
        double vx = SPEED - 2 * SPEED * cos * cos;
        double vy = -2 * SPEED * cos * sin;
        boolean isMissed = left.velocityX() == SPEED;
        trial.measure("misses", isMissed ? 1 : 0, "pairs", 0);
        double off = Math.hypot(left.velocityX() - vx, left.velocityY() - vy);
        trial.measure("velocity", off / SPEED, "of v", 1e-6, 1e-2);
        double after = right.velocityX();
        double met = (right.x() - x - after * pool.time()) / (-SPEED - after);
        trial.measure("time of impact", Math.abs(met - impact), "s", 1e-9, 1e-6);
    }
}
