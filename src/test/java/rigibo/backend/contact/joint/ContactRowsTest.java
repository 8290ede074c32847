package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;

/**
 * The load from which contacts count as strained. A load of j N·s gives a body of 2 kg a speed of
 * j/2 m/s.
 */
class ContactRowsTest {

    private static final int BODY = OneBody.BODY;

    private final Motions motions = OneBody.of(2);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final ContactRows contacts = new ContactRows(motions, null, rows, null);

    private int along(double impulse) {
        int row = rows.add();
        rows.derive(row, BODY, 0, 1, 0);
        rows.impulse[row] = impulse;
        rows.finish(row);
        return row;
    }

    private int load(double impulse) {
        int row = along(impulse);
        rows.contact[row] = 0;
        rows.lower[row] = 0;
        return row;
    }

    @Test
    void aLoadIsStressFromTenThousandTimesTheFastestSpeedOn() {
        load(1.9e4);
        assertThat(contacts.areStrained(1)).isFalse();
        assertThat(contacts.areStrained(0.9)).isTrue();
    }

    @Test
    void motorsAndSpringsExplainLoadsWhereNothingMoves() {
        load(1.9e4);
        int spring = along(2);
        rows.joint[spring] = 0;
        rows.give[spring] = 0.1;
        assertThat(contacts.areStrained(0)).isFalse();
        rows.impulse[spring] = 1.8;
        assertThat(contacts.areStrained(0)).isTrue();
        rows.give[spring] = 0;
        rows.upper[spring] = 5;
        rows.impulse[spring] = -2;
        assertThat(contacts.areStrained(0)).isFalse();
    }

    @Test
    void whatHoldsJointsTogetherExplainsNothing() {
        load(1.9e4);
        int equation = along(1e6);
        rows.joint[equation] = 0;
        assertThat(contacts.areStrained(0.9)).isTrue();
    }

    @Test
    void frictionAndJointsAreNoLoads() {
        int friction = load(1e6);
        rows.load[friction] = 0;
        rows.joint[along(1e6)] = 0;
        assertThat(contacts.areStrained(1)).isFalse();
    }
}
