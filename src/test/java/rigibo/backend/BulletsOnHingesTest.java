package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.SplittableRandom;

/**
 * Fast balls strike a bar that hangs on a hinge. Afterwards it turns so fast that its hinge needs
 * more substeps than were planned, and the step is made again: the impact has to come once more,
 * and be told once.
 */
class BulletsOnHingesTest {

    private static final int BALLS = 60;

    /**
     * Struck at a depth d, a bar with the moment of inertia I about its hinge takes J = (1 +
     * e)·v/(1/m + d²/I). The limit is that of J17; contacts of elasticity 0.8 and more part so fast
     * that the turning bar does not come back to the ball.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void ballsHandOnTheirMomentumOnce(Preset preset) {
        SplittableRandom random = new SplittableRandom(71);
        for (int i = 0; i < BALLS; i++) {
            double mass = Math.pow(10, 2 * random.nextDouble() - 1);
            double speed = 10 + 40 * random.nextDouble();
            double depth = 0.5 + 0.2 * random.nextDouble();
            double elasticity = 0.8 + 0.2 * random.nextDouble();
            String of = mass + " kg at " + speed + " m/s, " + depth + " m deep, e " + elasticity;
            strike(preset.accuracy, mass, speed, depth, elasticity, of);
        }
    }

    private static void strike(
            Accuracy accuracy,
            double mass,
            double speed,
            double depth,
            double elasticity,
            String of) {
        Pool pool = new Pool(JointScenes.SPACE, accuracy);
        RigidBody bar = pool.add(BodyDefinition.dynamic(Polygon.box(0.2, 1)).at(0, -0.5).mass(0.2));
        pool.join(RevoluteJoint.at(JointScenes.hook(pool, 0, 0), bar, 0, 0));
        double away = 0.2 + 1.3 * speed * Scenes.DT;
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.1))
                                .at(-away, -depth)
                                .velocity(speed, 0)
                                .material(new Material(1000, 0, elasticity))
                                .mass(mass));
        int impacts = 0;
        int told = 0;
        for (int step = 0; step < 2; step++) {
            pool.step(Scenes.DT);
            impacts += pool.report().impacts();
            told += pool.hits().size();
        }
        double inertia = bar.inertia() + bar.mass() / 4;
        double impulse = (1 + elasticity) * speed / (1 / mass + depth * depth / inertia);
        assertThat(ball.velocityX()).as(of).isCloseTo(speed - impulse / mass, within(1e-3 * speed));
        assertThat(bar.angularVelocity())
                .as(of)
                .isCloseTo(impulse * depth / inertia, within(2e-3 * speed / depth));
        assertThat(impacts).as("impacts of " + of).isEqualTo(1);
        assertThat(told).as("told of " + of).isEqualTo(1);
    }
}
