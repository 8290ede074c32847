package rigibo.lab.precision;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * A ball falls 2 m and rebounds with e = 0.8. Truth: after the n-th impact it has e²ⁿ of its
 * energy, and it loses none in between.
 */
final class BouncingBall {

    private static final double HEIGHT = 2;
    private static final double ELASTICITY = 0.8;
    private static final double RADIUS = 0.2;
    private static final double SECONDS = 5;
    private static final Bounces TRUTH = new Bounces(HEIGHT, ELASTICITY);

    private BouncingBall() {}

    /** Simulates the ball in an engine at a setting. */
    static EnergyTrace trace(Engine engine, Setting setting) {
        Effects effects = Earth.effects().without(Friction.class).without(Rotation.class);
        try (World world = engine.world(effects, setting)) {
            world.add(Earth.floor(0, ELASTICITY));
            int ball = world.add(Solid.disc(RADIUS, 0, ELASTICITY).at(0, HEIGHT + RADIUS));
            return sample(engine, setting, world, ball);
        }
    }

    private static EnergyTrace sample(Engine engine, Setting setting, World world, int ball) {
        int steps = (int) Math.round(SECONDS / setting.step());
        double[] seconds = new double[steps + 1];
        double[] energy = new double[steps + 1];
        double[] byDesign = new double[steps + 1];
        double[] drift = new double[steps + 1];
        for (int i = 0; i <= steps; i++) {
            if (i > 0) {
                world.step(setting.step());
            }
            double apex = Bounces.apexOf(world.y(ball) - RADIUS, world.velocityY(ball));
            seconds[i] = i * setting.step();
            energy[i] = apex / HEIGHT;
            byDesign[i] = TRUTH.apexAt(seconds[i]) / HEIGHT;
            drift[i] = TRUTH.apexError(seconds[i], setting.step(), apex);
        }
        return new EnergyTrace(engine.name(), setting.name(), seconds, energy, byDesign, drift);
    }
}
