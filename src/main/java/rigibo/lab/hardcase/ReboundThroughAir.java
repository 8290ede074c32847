package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Truth with the terminal speed w: a ball dropped through H hits at v² = w²(1 − e^(−2gH/w²)),
 * rebounds without loss, and rises to w²/2g·ln(1 + v²/w²). From its first speed v upwards it takes
 * w²/g·ln(1/cos(atan(v/w))) to the apex. The heights put the impact at every phase of a step.
 */
final class ReboundThroughAir implements Scenes {

    private static final double TERMINAL = 20;
    private static final double RADIUS = 0.5;
    private static final int PHASES = 25;

    @Override
    public void run(Trial trial) {
        for (int phase = 0; phase < PHASES; phase++) {
            trial.variant("phase " + phase);
            double height = 5 + 0.01 * phase;
            double squared = TERMINAL * TERMINAL;
            double share = 1 - Math.exp(-2 * Trial.GRAVITY * height / squared);
            double apex = squared / (2 * Trial.GRAVITY) * Math.log1p(share);
            trial.relativeError("apex", apexOf(trial, height), apex, "relative", 1e-6, 1e-5);
        }
    }

    private static double apexOf(Trial trial, double height) {
        double density = 2 * Trial.GRAVITY / (TERMINAL * TERMINAL * 2 * RADIUS);
        WatchedPool pool =
                trial.pool(
                        Effects.of(
                                new Gravity(0, -Trial.GRAVITY),
                                new Contacts(),
                                new Restitution(),
                                new ContinuousImpacts(),
                                new AirDrag(density, 1)));
        pool.add(Earth.floor(0, 1));
        RigidBody ball = pool.add(Solid.disc(RADIUS, 0, 1).mass(1).at(0, height + RADIUS));
        while (ball.velocityY() <= 0) {
            pool.step();
        }
        double left = Math.cos(Math.atan(ball.velocityY() / TERMINAL));
        return ball.y() - RADIUS - TERMINAL * TERMINAL / Trial.GRAVITY * Math.log(left);
    }
}
