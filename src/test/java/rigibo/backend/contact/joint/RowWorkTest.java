package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;

/** Rows that push a body of 2 kg and 2 kg·m². Work is impulse times mean speed. */
class RowWorkTest {

    private static final int BODY = OneBody.BODY;
    private static final double ROUND_OFF = 1e-12;

    private final Motions motions = OneBody.of(2);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final RowWork work = new RowWork(motions, rows);
    private int load;
    private int friction;
    private int joint;

    /** A load along x, its friction along y on a surface that runs at 0.25 m/s, and a hinge. */
    @BeforeEach
    void lay() {
        load = row(1, 0, 0);
        rows.contact[load] = 0;
        friction = row(0, 1, 0);
        rows.contact[friction] = 0;
        rows.load[friction] = load;
        rows.loads[friction] = 1;
        rows.target[friction] = 0.25;
        joint = row(0, 0, 1);
        rows.joint[joint] = 0;
        rows.holdsPlace[joint] = true;
    }

    private int row(double x, double y, double turn) {
        int row = rows.add();
        rows.derive(row, BODY, x, y, turn);
        rows.finish(row);
        return row;
    }

    private void go(double x, double y, double spin) {
        motions.data[BODY + Motions.VX] = x;
        motions.data[BODY + Motions.VY] = y;
        motions.data[BODY + Motions.SPIN] = spin;
    }

    /**
     * Impulses of 2, 3 and 5 make speeds of half of them from rest, and their work is the impulse
     * times half that speed.
     */
    @Test
    void workIsDoneAtTheMeanOfTheSpeedsBeforeAndAfter() {
        work.begin();
        rows.push(load, 2);
        rows.push(friction, 3);
        rows.push(joint, 5);
        assertThat(work.sum())
                .isCloseTo(2 * 1 / 2.0 + 3 * 1.5 / 2 + 5 * 2.5 / 2, within(ROUND_OFF));
        assertThat(work.isAllOfRows()).isTrue();
        motions.data[BODY + Motions.VX] += 1e-3;
        assertThat(work.isAllOfRows()).isFalse();
    }

    /**
     * The work of a joint that holds while it turns does not count, nor does friction at the speed
     * of its surface.
     */
    @Test
    void onlyContactsAreAskedAtTheSpeedsThatTheyHaveNow() {
        rows.impulse[load] = 2;
        rows.impulse[friction] = 3;
        rows.impulse[joint] = 5;
        go(0, 0.25, 1);
        assertThat(work.sumOfContactsNow()).isZero();
        go(0.5, 0.25, 1);
        assertThat(work.sumOfContactsNow()).isCloseTo(2 * 0.5, within(ROUND_OFF));
        go(0, -0.25, 1);
        assertThat(work.sumOfContactsNow()).isCloseTo(3 * -0.5, within(ROUND_OFF));
    }
}
