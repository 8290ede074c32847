package rigibo.backend.collision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

/** A body has stayed if it was compared before and has the same pose to the last bit. */
class WhereaboutsTest {

    private final FilledStorage scene = new FilledStorage(new Contacts(), new Rotation());
    private final Whereabouts whereabouts = new Whereabouts();

    /** A body at the origin, where columns that were not written yet also place it. */
    private final int body = scene.add(BodyDefinition.dynamic(new Circle(1)));

    @Test
    void whoWasNeverLookedForHasNotStayed() {
        whereabouts.begin(scene.bodies);
        assertThat(hasStayed(body)).isFalse();
    }

    @Test
    void whoIsWhereItWasHasStayedAndWhoMovedALittleHasNot() {
        whereabouts.begin(scene.bodies);
        whereabouts.compare(scene.bodies, body);
        whereabouts.begin(scene.bodies);
        assertThat(hasStayed(body)).isTrue();
        scene.bodies.angle[body] = Double.MIN_VALUE;
        whereabouts.begin(scene.bodies);
        assertThat(hasStayed(body)).isFalse();
    }

    /** There are more bodies than the first capacity. */
    @Test
    void whoComesLaterHasNotStayedEither() {
        whereabouts.begin(scene.bodies);
        for (int i = 0; i < 100; i++) {
            scene.add(BodyDefinition.dynamic(new Circle(1)));
        }
        whereabouts.begin(scene.bodies);
        assertThat(hasStayed(100)).isFalse();
    }

    private boolean hasStayed(int slot) {
        whereabouts.compare(scene.bodies, slot);
        return whereabouts.hasStayed(slot);
    }
}
