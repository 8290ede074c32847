package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.PairTolerances;

/**
 * A point of a body of 2 kg, 1 m wide, over the ground, in a last kick: whether it keeps its load
 * or aims at closing its gap in no time.
 */
class RowsOfLastKickTest {

    /** Time that is left as if a drift followed, s. */
    private static final double LEFT = 0.01;

    private final PackedContacts contacts = new PackedContacts();
    private final NeutralRows rows;
    private final ContactRows contactRows;

    RowsOfLastKickTest() {
        Motions motions = OneBody.of(2);
        rows = new NeutralRows(motions, null);
        RowStates states = new RowStates();
        states.clear(0, 1);
        contactRows = new ContactRows(motions, contacts, rows, states);
        contacts.count = 1;
        contacts.points[0] = 1;
        contacts.firstSubstep[0] = PackedContacts.ALWAYS;
        contacts.bodyB[0] = OneBody.BODY;
        contacts.data[PackedContacts.NY] = 1;
        contacts.data[PackedContacts.WIDTH] = 1;
    }

    /** Returns the speed at which the point's row aims, m/s. */
    private double target(double gap, double load) {
        contacts.data[PackedContacts.GAP0] = gap;
        contacts.data[PackedContacts.IMPULSE0] = load;
        rows.clear();
        contactRows.writeAtRest(LEFT, 1);
        assertThat(rows.count).isEqualTo(1);
        return rows.target[0];
    }

    @Test
    void aLoadStaysOnWhatTouches() {
        double touching = PairTolerances.TOUCHING_GAP;
        assertThat(target(0.99 * touching, 1e-9)).isEqualTo(0);
        assertThat(target(1.01 * touching, 1e-9)).isCloseTo(-101 * touching, within(1e-12));
    }

    @Test
    void whatTouchesIsAShareOfTheWidth() {
        contacts.data[PackedContacts.WIDTH] = 3;
        assertThat(target(2.99 * PairTolerances.TOUCHING_GAP, 1e-9)).isEqualTo(0);
        assertThat(target(3.01 * PairTolerances.TOUCHING_GAP, 1e-9)).isNegative();
    }

    /** A body that is wedged between others carries any load for an instant. */
    @Test
    void noLoadHoldsWhatIsApart() {
        assertThat(target(0.01, 1e9)).isCloseTo(-1, within(1e-12));
    }

    @Test
    void aPointWithoutLoadFallsFreely() {
        assertThat(target(0.5 * PairTolerances.TOUCHING_GAP, 0)).isNegative();
    }

    @Test
    void aLoadStaysAtTheSpeedAtWhichItsSurfacesNear() {
        contacts.data[PackedContacts.NEARING] = -0.3;
        assertThat(target(0.5 * PairTolerances.TOUCHING_GAP, 0.8)).isEqualTo(-0.3);
    }

    @Test
    void anOverlapDoesNotPush() {
        assertThat(target(-0.2, 0)).isEqualTo(0);
    }
}
