package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Material;

import java.util.Random;

/** Impacts with friction of bodies that turn by up to a radian in a step. */
class SpinningImpactsTest {

    private static final double DT = 1.0 / 60;
    private static final double G = 9.81;
    private static final int SCENES = 200;
    private static final int STEPS = 20;
    private static final double LEAST_HEIGHT = 0.5;
    private static final Effects EFFECTS =
            Effects.of(
                    new Gravity(0, -G),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new ContinuousImpacts());

    /**
     * An impact takes energy or leaves it. A body may be lifted only out of an overlap up to the
     * tolerance of impacts, and has at least the energy of half a metre's height.
     */
    @ParameterizedTest
    @CsvSource({"GAME, true", "FINE, true", "EXACT, true", "GAME, false", "EXACT, false"})
    void gainNoEnergy(Preset preset, boolean isLocked) {
        bounce(preset.accuracy, isLocked);
    }

    @ParameterizedTest
    @CsvSource({"true", "false"})
    void gainNoEnergyInPasses(boolean isLocked) {
        bounce(
                Accuracy.GAME.withImpacts(ImpactMode.SPLIT).withContactSolver(ContactSolver.BLOCK),
                isLocked);
    }

    private static void bounce(Accuracy accuracy, boolean isLocked) {
        int hits = 0;
        for (int seed = 0; seed < SCENES; seed++) {
            Random random = new Random(seed);
            double elasticity = random.nextInt(3) == 0 ? 1 : random.nextDouble();
            Material material = new Material(1, 1.2 * random.nextDouble(), elasticity);
            Pool pool = new Pool(EFFECTS, accuracy);
            pool.add(BodyDefinition.fixed(Polygon.box(50, 1)).at(0, -0.5).material(material));
            BodyDefinition box =
                    BodyDefinition.dynamic(Polygon.box(0.4, 0.6))
                            .at(0, LEAST_HEIGHT + random.nextDouble())
                            .angle(2 * Math.PI * random.nextDouble())
                            .velocity(0, -5 * random.nextDouble())
                            .spin(120 * random.nextDouble() - 60)
                            .material(material);
            RigidBody body = pool.add(isLocked ? box.lockX() : box);
            double start = energy(body);
            for (int step = 0; step < STEPS; step++) {
                double before = energy(body);
                pool.step(DT);
                assertThat((energy(body) - before) / start)
                        .as("seed %d, step %d", seed, step)
                        .isLessThan(accuracy.impactTolerance() / LEAST_HEIGHT);
                hits += pool.hits().size();
            }
        }
        assertThat(hits).isGreaterThan(SCENES / 2);
    }

    private static double energy(RigidBody body) {
        double speed = Math.hypot(body.velocityX(), body.velocityY());
        double spin = body.angularVelocity();
        return body.mass() * (G * body.y() + speed * speed / 2) + body.inertia() * spin * spin / 2;
    }
}
