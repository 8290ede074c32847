package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.contact.row.SharedRows;

/** One contact between a body of 1 kg and the ground, in a substep of 1/256 s. */
class DueContactsTest {

    private static final double H = 1.0 / 256;
    private static final int BODY = Motions.STRIDE;

    /** The neglected change of speed, m/s. */
    private static final double QUIET = 0.25;

    private final PackedIsland island = new PackedIsland();
    private final DueContacts due =
            new DueContacts(island.motions, island.contacts, new SharedRows(null, island.contacts));
    private int row;

    @BeforeEach
    void begin() {
        island.begin(1);
        island.body(1, 1, 1);
        row = island.onGround(1, 0.5, 0.5);
        due.begin(H, 0, Double.POSITIVE_INFINITY, QUIET, QUIET);
    }

    private boolean isDue() {
        return due.changed[1] - due.seen[row] > due.threshold[row];
    }

    @Test
    void everyContactIsDueAtTheStart() {
        assertThat(isDue()).isTrue();
    }

    @Test
    void aSolvedContactIsDueAgainAfterMoreThanTheNeglectedChange() {
        due.seen[row] = due.changed[1];
        due.threshold[row] = due.threshold(row, 1, 0);
        assertThat(isDue()).isFalse();
        due.changed[1] += QUIET;
        assertThat(isDue()).isFalse();
        due.changed[1] += 1e-9;
        assertThat(isDue()).isTrue();
    }

    @Test
    void deferredContactsWaitForAChangeUnlessTheyAreNew() {
        island.contacts.isNew[row] = true;
        due.deferAllButNew();
        assertThat(isDue()).isTrue();
        island.contacts.isNew[row] = false;
        due.deferAllButNew();
        assertThat(isDue()).isFalse();
    }

    /** At 1 m/s a body sinks in by 1/256 m in a substep. */
    @Test
    void sinkingIsTheSpeedTimesTheSubstep() {
        double widths = H / island.contacts.width(row);
        island.motions.data[BODY + Motions.VY] = -1;
        assertThat(due.isSinking(H, 0, 0.99 * widths)).isTrue();
        assertThat(due.isSinking(H, 0, 1.01 * widths)).isFalse();
    }
}
