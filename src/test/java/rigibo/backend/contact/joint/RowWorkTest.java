package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/** Rows that push a body of 2 kg and 2 kg·m². Work is impulse times mean speed. */
class RowWorkTest {

    private static final int BODY = OneBody.BODY;
    private static final double ROUND_OFF = 1e-12;

    private final Motions motions = OneBody.of(2);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final NearRows near = new NearRows(motions, rows, Accuracy.GAME);
    private final RowWork work = new RowWork(motions, rows, near);
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
        near.begin();
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
     * A push of 2 N·s against a load that stops it again: the load seems to do 2 · 1/2 J at mean
     * speeds, which it takes from the push. At the speed that is left it does none.
     */
    @Test
    void whatOnlyStopsAPushDoesNoWork() {
        int push = row(1, 0, 0);
        rows.joint[push] = 0;
        go(-1, 0, 0);
        work.begin();
        rows.push(load, -2);
        rows.push(push, 4);
        assertThat(rows.speed(load)).isZero();
        assertThat(work.sum()).isZero();
    }

    /** A limit pressed by 5 N·m·s that gives way by 0.1 rad/s for each of them, as it aims at. */
    @Test
    void aTautLimitMayMoveAsItGivesWay() {
        rows.lower[joint] = 0;
        rows.target[joint] = 3;
        rows.give[joint] = 0.1;
        work.begin();
        rows.push(joint, 5);
        assertThat(work.sum()).isCloseTo(5 * (2.5 / 2 - (3 - 0.5)), within(ROUND_OFF));
        rows.give[joint] = 0;
        assertThat(work.sum()).isCloseTo(5 * 2.5 / 2, within(ROUND_OFF));
    }

    /** Kept near 3 N·s, a load of 2 moves at a share of its response for the third. */
    @Test
    void aContactMayMoveSinceItIsKeptNearItsLastLoad() {
        near.keep(load, 3);
        rows.impulse[load] = 2;
        double speed = near.speedOf(load);
        assertThat(speed).isCloseTo(rows.give[load], within(ROUND_OFF)).isPositive();
        go(speed, 0, 0);
        assertThat(work.sumOfContactsNow()).isZero();
        go(2 * speed, 0, 0);
        assertThat(work.sumOfContactsNow()).isCloseTo(2 * speed, within(ROUND_OFF));
    }

    /** What is taut would give way to its loads if only its target were taken from it. */
    @Test
    void rowsAtRestAreRigidAndDrawNothing() {
        rows.target[load] = 0.2;
        rows.target[joint] = -0.3;
        rows.give[joint] = 0.1;
        rows.lower[joint] = 0;
        work.rest();
        assertThat(rows.target[load]).isZero();
        assertThat(rows.target[joint]).isEqualTo(-0.3);
        assertThat(rows.give[joint]).isZero();
        rows.lower[joint] = Double.NEGATIVE_INFINITY;
        work.rest();
        assertThat(rows.target[joint]).isZero();
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
