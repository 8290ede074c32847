package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.DataStorage;

/** Two discs of 1 m side by side, measured at their places within the step. */
class FreshRowsTest {

    private final Pool pool = new Pool(Effects.of(new Contacts()), Accuracy.GAME);
    private final DataStorage data;
    private final int pair;
    private final Motions motions = new Motions(false);
    private final PackedContacts contacts = new PackedContacts();
    private final FreshRows fresh;
    private final int row;

    FreshRowsTest() {
        pool.add(BodyDefinition.dynamic(new Circle(1)));
        pool.add(BodyDefinition.dynamic(new Circle(1)).at(2, 0));
        pool.step(1e-3);
        data = PoolStorage.of(pool);
        pair = data.pairs.active[0];
        motions.clear(data.bodies);
        row = contacts.add();
        contacts.pair[row] = pair;
        contacts.bodyA[row] = motions.offset(data.bodies, data.pairs.bodyA[pair]);
        contacts.bodyB[row] = motions.offset(data.bodies, data.pairs.bodyB[pair]);
        RowBuilder builder = new RowBuilder(data, motions, contacts, null);
        fresh =
                new FreshRows(
                        data,
                        new Narrowphase(data),
                        motions,
                        contacts,
                        builder,
                        new SharedRows(null, contacts));
    }

    /** The disc is up and to the right of the other, √2 m away. */
    @Test
    void contactIsMeasuredWhereItsBodiesAreByNow() {
        motions.data[contacts.bodyB[row] + Motions.DX] = -1;
        motions.data[contacts.bodyB[row] + Motions.DY] = 1;
        fresh.measure(row, 1);
        assertThat(data.pairs.normalX[pair]).isEqualTo(Math.sqrt(0.5), within(1e-12));
        assertThat(data.pairs.normalY[pair]).isEqualTo(Math.sqrt(0.5), within(1e-12));
        assertThat(data.pairs.separation[2 * pair]).isEqualTo(Math.sqrt(2) - 2, within(1e-12));
    }

    /** The square of its distance is infinite, and would give no normal. */
    @ParameterizedTest
    @ValueSource(doubles = {1e155, 1e200, 1e308, Double.POSITIVE_INFINITY, Double.NaN})
    void whatIsTooFarAwayForADistanceIsNotMeasured(double x) {
        motions.data[contacts.bodyB[row] + Motions.DX] = x;
        // Its speed would take it there, so any place is within reach.
        motions.data[contacts.bodyB[row] + Motions.VX] = x;
        fresh.measure(row, 1);
        assertThat(data.pairs.normalX[pair]).isEqualTo(1);
        assertThat(data.pairs.normalY[pair]).isZero();
        assertThat(data.pairs.separation[2 * pair]).isZero();
    }
}
