package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.List;

/** Contacts are reported when they begin, while they last and when they end. */
class ContactEventsTest {

    private final Pool pool = Scenes.restless();
    private final RigidBody floor = Scenes.addFloor(pool);

    @Test
    void landingBeginsPersistsAndEnds() {
        RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.6));
        // From 0.1 m the fall takes √(2·0.1/9.81) = 0.143 s, 8.6 steps.
        for (int step = 1; step <= 8; step++) {
            pool.step(Scenes.DT);
            assertThat(pool.contactEvents()).as("step %d", step).isEmpty();
            assertThat(pool.touching(box, floor)).isFalse();
        }
        pool.step(Scenes.DT);
        assertThat(onlyEvent().phase()).isEqualTo(Phase.BEGIN);
        assertThat(pool.touching(box, floor)).isTrue();
        for (int step = 0; step < 30; step++) {
            pool.step(Scenes.DT);
            assertThat(onlyEvent().phase()).as("step %d", step).isEqualTo(Phase.PERSIST);
        }
        box.velocity(0, 5);
        // It still touches when the step in which it leaves begins; END may come with the next.
        pool.step(Scenes.DT);
        if (onlyEvent().phase() != Phase.END) {
            pool.step(Scenes.DT);
        }
        assertThat(onlyEvent().phase()).isEqualTo(Phase.END);
        assertThat(pool.touching(box, floor)).isFalse();
        pool.step(Scenes.DT);
        assertThat(pool.contactEvents()).isEmpty();
    }

    @Test
    void eventTellsBodiesPointNormalAndImpulse() {
        RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(3, 0.5));
        Scenes.run(pool, 60);
        ContactEvent event = onlyEvent();
        assertThat(List.of(event.a(), event.b())).containsExactlyInAnyOrder(floor, box);
        assertThat(event.x()).isCloseTo(3, within(1e-6));
        assertThat(event.y()).isCloseTo(0, within(1e-3));
        // The normal points from a to b: up where the floor is a.
        assertThat(event.normalY()).isCloseTo(event.a() == floor ? 1 : -1, within(1e-9));
        assertThat(event.impulse()).isCloseTo(box.mass() * 9.81 * Scenes.DT, within(1e-6));
    }

    @Test
    void bounceWithinAStepIsTold() {
        pool.add(
                BodyDefinition.dynamic(new Circle(0.5))
                        .at(0, 1)
                        .velocity(0, -60)
                        .material(new Material(1, 0, 1)));
        pool.step(Scenes.DT);
        assertThat(onlyEvent().phase()).isEqualTo(Phase.BEGIN);
        // Twice the momentum it arrives with, at 60 m/s and a little more.
        assertThat(onlyEvent().impulse()).isCloseTo(2 * Math.PI / 4 * 60, within(1.0));
        pool.step(Scenes.DT);
        assertThat(onlyEvent().phase()).isEqualTo(Phase.END);
    }

    @Test
    void nearMissIsNoContact() {
        pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(0, 5));
        pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(1.01, 5));
        pool.step(Scenes.DT);
        assertThat(pool.contactEvents()).isEmpty();
    }

    @Test
    void bodiesOfAGroupNeverTouch() {
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.5)).group(3);
        RigidBody one = pool.add(disc.at(0, 5).velocity(1, 0));
        RigidBody two = pool.add(disc.at(1.5, 5).velocity(-1, 0));
        Scenes.run(pool, 40);
        assertThat(pool.touching(one, two)).isFalse();
        assertThat(one.velocityX()).isEqualTo(1);
    }

    private ContactEvent onlyEvent() {
        assertThat(pool.contactEvents()).hasSize(1);
        return pool.contactEvents().get(0);
    }
}
