package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Room is made beforehand, or by the step that needs it, which tells. */
class ReserveTest {

    /** Discs to a side of a square, which come together. */
    private static final int SIDE = 14;

    /** m, several times what a fixture reaches beyond its disc. */
    private static final double APART = 3;

    /** They would all be in the middle after a third of a second. */
    private static final int STEPS = 20;

    @Test
    void stepThatMakesRoomTellsAndOneWithRoomMakesNone() {
        Pool growing = flood(new Pool());
        Pool roomy = new Pool();
        roomy.reserve(SIDE * SIDE + 1, 10_000);
        flood(roomy);
        roomy.step(Scenes.DT);
        growing.step(Scenes.DT);
        int least = growing.report().pairRoom();
        int room = roomy.report().pairRoom();
        assertThat(room).isGreaterThanOrEqualTo(10_000);
        for (int i = 0; i < STEPS; i++) {
            roomy.step(Scenes.DT);
            growing.step(Scenes.DT);
            assertThat(roomy.report().pairRoom()).as("step %d", i).isEqualTo(room);
            assertThat(growing.report().pairRoom())
                    .as("step %d", i)
                    .isGreaterThanOrEqualTo(growing.report().pairs());
        }
        assertThat(growing.report().pairRoom()).isBetween(least + 1, room - 1);
        assertThat(roomy.stateHash()).as("room changes nothing").isEqualTo(growing.stateHash());
    }

    /** Discs far enough apart to have no pairs, thrown at one place. */
    private static Pool flood(Pool pool) {
        pool.effects(Scenes.restless().effects());
        pool.accuracy(Accuracy.DRAFT);
        for (int i = 0; i < SIDE * SIDE; i++) {
            double x = APART * (i % SIDE - SIDE / 2.0);
            double y = APART * (i / SIDE - SIDE / 2.0);
            pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(x, y).velocity(-3 * x, -3 * y));
        }
        return pool;
    }

    @Test
    void roomOutOfRangeIsRefusedNamingIt() {
        assertThatThrownBy(() -> new Pool().reserve(-1, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Pool.reserve bodies");
        assertThatThrownBy(() -> new Pool().reserve(0, Integer.MAX_VALUE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Pool.reserve pairs");
    }
}
