package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.DataStorage;

/** A box and a disc that turn. */
class TurningRowsTest {

    private static final double H = 1 / 240.0;

    private final Pool pool = new Pool(Effects.of(new Contacts(), new Rotation()), Accuracy.GAME);
    private final Motions motions = new Motions(true);
    private final TurningRows turning;

    TurningRowsTest() {
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)));
        pool.add(BodyDefinition.dynamic(new Circle(1)).at(5, 0));
        DataStorage data = PoolStorage.of(pool);
        motions.clear(data.bodies);
        motions.offset(data.bodies, 0);
        motions.offset(data.bodies, 1);
        turning = new TurningRows(data, motions, new PackedContacts(), null, null);
    }

    /** As many parts as tenths of a radian, rounded up, from one to eight. */
    @ParameterizedTest
    @CsvSource({"0, 1", "20, 1", "-25, 2", "47, 2", "49, 3", "-190, 8", "1000, 8"})
    void partsAreAsManyAsTheCornersTurn(double spin, int parts) {
        motions.data[Motions.STRIDE + Motions.SPIN] = spin;
        assertThat(turning.partsFor(H)).isEqualTo(parts);
    }

    /** Its outline stays in place. */
    @Test
    void discMayTurnAsItLikes() {
        motions.data[2 * Motions.STRIDE + Motions.SPIN] = 1000;
        assertThat(turning.partsFor(H)).isEqualTo(1);
    }
}
