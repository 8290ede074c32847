package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Material;

/** The impulses that contacts report where numbers are out of all bounds. */
class ToldImpulseTest {

    private static final Effects EFFECTS =
            Effects.of(
                    new Contacts(),
                    new Friction(),
                    new Restitution(),
                    new ContinuousImpacts(),
                    new Rotation());

    /**
     * An inertia of 10⁻³⁵ kg·m² turns what round-off leaves of a lever into any speed: the impact
     * puts both to rest, and is told as if it had not been.
     */
    @Test
    void impactBeyondAllBoundsIsNotTold() {
        Accuracy accuracy = Accuracy.FINE.withContactSolver(ContactSolver.BLOCK);
        Pool pool = new Pool(EFFECTS, accuracy);
        pool.add(
                BodyDefinition.dynamic(Polygon.box(1.4, 36.6))
                        .at(4.1, 10.42)
                        .angle(1.23)
                        .velocity(-10.7, 20.6)
                        .material(new Material(0.39, 0.03, 0)));
        RigidBody light =
                pool.add(
                        BodyDefinition.dynamic(Polygon.regular(7, 0.2))
                                .at(14.6, 4)
                                .velocity(11, 60)
                                .inertia(2.7e-35)
                                .material(new Material(2, 1.2, 1)));
        boolean wasPutToRest = false;
        for (int i = 0; i < 60; i++) {
            pool.step(1.0 / 60);
            wasPutToRest |= pool.report().quarantined() > 0;
            assertThat(pool.contactEvents())
                    .allSatisfy(
                            event -> assertThat(event.impulse()).isBetween(0.0, Double.MAX_VALUE));
        }
        assertThat(wasPutToRest).as("%s", light).isTrue();
    }
}
