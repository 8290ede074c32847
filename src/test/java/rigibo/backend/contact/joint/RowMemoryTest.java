package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/** A body of 1 kg that moves at 1/4 and 1/2 m/s, and one row that pushes it along x. */
class RowMemoryTest {

    private static final int BODY = Motions.STRIDE;

    private final Motions motions = new Motions(true);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final RowMemory memory = new RowMemory(motions, rows);
    private final int row;

    RowMemoryTest() {
        motions.data = new double[2 * Motions.STRIDE];
        motions.slots = new int[2];
        motions.count = 2;
        motions.data[BODY + Motions.INVERSE_MASS] = 1;
        motions.data[BODY + Motions.VX] = 0.25;
        motions.data[BODY + Motions.VY] = 0.5;
        row = rows.add();
        rows.derive(row, BODY, 1, 0, 0);
        rows.finish(row);
        memory.keep();
    }

    @Test
    void goesBackToWhatWasKept() {
        rows.push(row, 3);
        memory.recall();

        assertThat(rows.impulse[row]).isZero();
        assertThat(motions.data[BODY + Motions.VX]).isEqualTo(0.25);
    }

    /** A speed of 1/4 m/s is lost beside 10²⁰; the impulse in the end is 2 N·s. */
    @Test
    void redoingLeavesNothingOfHugeImpulsesOnTheWay() {
        for (double push : new double[] {1e20, -1e20, 2}) {
            rows.push(row, push);
        }
        assertThat(motions.data[BODY + Motions.VX]).isEqualTo(2);
        memory.redo();

        assertThat(Arrays.copyOfRange(motions.data, BODY, BODY + 2)).containsExactly(2.25, 0.5);
        assertThat(rows.impulse[row]).isEqualTo(2);
    }
}
