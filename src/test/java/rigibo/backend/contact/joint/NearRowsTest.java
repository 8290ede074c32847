package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/** A row with a bound, of a body of 2 kg and 2 kg·m², whose last impulse was 3 N·s. */
class NearRowsTest {

    private static final double ROUND_OFF = 1e-15;
    private static final double LAST = 3;

    private final Motions motions = OneBody.of(2);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final int row = add();

    private int add() {
        int added = rows.add();
        rows.joint[added] = 0;
        rows.lower[added] = 0;
        rows.target[added] = 0.25;
        rows.derive(added, OneBody.BODY, 1, 0, 0);
        rows.finish(added);
        return added;
    }

    /** w + g·D·(j − c) with g = 10 times the tolerance of 1e-4 m, and D = 1/2 kg. */
    @Test
    void aRowGivesWayToTheChangeOfItsImpulse() {
        NearRows near = new NearRows(motions, rows, Accuracy.GAME);
        near.keep(row, LAST);
        rows.impulse[row] = LAST;
        assertThat(rows.residual(row)).isCloseTo(-0.25, within(ROUND_OFF));
        rows.impulse[row] = LAST + 4;
        assertThat(rows.residual(row)).isCloseTo(1e-3 / 2 * 4 - 0.25, within(ROUND_OFF));
    }

    @Test
    void softeningRestoresWhatWasWritten() {
        NearRows near = new NearRows(motions, rows, Accuracy.GAME);
        near.begin();
        near.keep(row, LAST);
        near.soften(0.5);
        assertThat(rows.target[row]).isEqualTo(0.25);
        assertThat(rows.give[row]).isZero();
    }

    /** One body moves in three ways, and four brakes along x hold more than that. */
    @Test
    void moreRowsThanWaysToMoveAreKeptNearButAtExact() {
        assertThat(new NearRows(motions, rows, Accuracy.GAME).areWanted()).isFalse();
        add();
        add();
        add();
        assertThat(new NearRows(motions, rows, Accuracy.GAME).areWanted()).isTrue();
        assertThat(new NearRows(motions, rows, Accuracy.EXACT).areWanted()).isFalse();
    }
}
