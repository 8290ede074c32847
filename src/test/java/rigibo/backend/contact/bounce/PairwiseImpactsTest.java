package rigibo.backend.contact.bounce;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Material;

/** Rebounds within the substeps of a pile that passes solve. */
class PairwiseImpactsTest {

    private static final double G = 9.81;
    private static final double DT = 1.0 / 60;
    private static final Material ELASTIC = new Material(1, 0, 1);
    private static final Effects EFFECTS =
            Effects.of(
                    new Gravity(0, -G),
                    new Contacts(),
                    new Rotation(),
                    new Restitution(),
                    new ContinuousImpacts());

    private static final Accuracy PASSED =
            Accuracy.GAME.withImpacts(ImpactMode.SPLIT).withContactSolver(ContactSolver.BLOCK);

    /**
     * A ball that loses nothing keeps its energy, wherever in a substep or a step it bounces: it
     * goes on a parabola to the impact and from there on its mirror image, so that only round-off
     * is left, of the order of 10⁻¹⁶ of 2 m for each of 300 steps. With the velocity of the
     * substep's middle it would be off by h·v, 0.02 m; held in the kick that ends a step it would
     * stop.
     */
    @Test
    void ballBouncesAsHighAsItFell() {
        for (int phase = 0; phase < 25; phase++) {
            double height = 1 + 0.01 * phase;
            Pool pool = new Pool(EFFECTS, PASSED);
            pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, -0.5).material(ELASTIC));
            RigidBody ball =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.5))
                                    .at(0, 0.5 + height)
                                    .material(ELASTIC));
            int bounces = 0;
            for (int step = 1; step <= 300; step++) {
                double before = ball.velocityY();
                pool.step(DT);
                bounces += before < 0 && ball.velocityY() > 0 ? 1 : 0;
                double reached = ball.y() - 0.5 + ball.velocityY() * ball.velocityY() / (2 * G);
                assertThat(reached)
                        .as("phase %d, step %d", phase, step)
                        .isEqualTo(height, within(1e-12));
            }
            assertThat(bounces).isGreaterThanOrEqualTo(5);
        }
    }
}
