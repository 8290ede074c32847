package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.contact.row.Motions;

/** Rods and ropes that draw their ends back to their line. */
class TautLinesTest {

    private static final double KICK = 1.0 / 120;
    private static final double DRIFT = 1.0 / 60;

    /** N. */
    private static final double PULL = 3e4;

    private static final int A = Motions.STRIDE;
    private static final int B = 2 * Motions.STRIDE;

    private final JointedIsland island = new JointedIsland();
    private final NeutralRows rows = island.rows;

    /** A line between the centres, by which no end turns. */
    private JointDefinition rod() {
        return DistanceJoint.rod(island.a, 0.3, 0.2, island.b, 1.4, -0.3);
    }

    private JointDefinition rope() {
        double length = Math.hypot(1.1, 0.5);
        return DistanceJoint.rope(island.a, 0.3, 0.2, island.b, 1.4, -0.3, length);
    }

    /** Writes the rows of a line whose row had an impulse in the last kick, N·s. */
    private void write(JointDefinition line, int part, double impulse) {
        write(line, part, impulse, 0);
    }

    private void write(JointDefinition line, int part, double impulse, double kept) {
        island.pool.join(line);
        island.pack(1, KICK);
        island.packed.impulse[part] = impulse;
        island.poses.take(0);
        rows.clear();
        island.lines.begin(KICK, kept);
        island.jointRows.write(KICK, DRIFT);
    }

    /**
     * Ends that part across at the speed w are off their line by h·w after a drift of h seconds,
     * and are drawn back by F/l times that.
     */
    private void assertDrawnBack(int row) {
        double length = Math.hypot(1.1, 0.5);
        double across = 0.7;
        island.motions.data[B + Motions.VX] = across * 0.5 / length;
        island.motions.data[B + Motions.VY] = across * 1.1 / length;
        island.motions.data[A + Motions.SPIN] = 3;
        rows.impulse[row] = -KICK * PULL / length * DRIFT * across;
        assertThat(rows.residual(row)).isCloseTo(0, within(1e-9));
        rows.impulse[row] = 0;
        assertThat(rows.residual(row)).isCloseTo(across, within(1e-9));
    }

    @Test
    void rodThatPullsDrawsItsEndsBack() {
        write(rod(), JointRows.X, -KICK * PULL);
        assertThat(rows.count).isEqualTo(2);
        assertDrawnBack(1);
    }

    @Test
    void ropeThatPullsDrawsItsEndsBack() {
        write(rope(), JointRows.UPPER, KICK * PULL);
        assertThat(rows.count).isEqualTo(2);
        assertDrawnBack(1);
    }

    /** A rod that is pressed pushes its ends away from its line. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 100})
    void lineThatDoesNotPullHasNoRowAcross(double impulse) {
        write(rod(), JointRows.X, impulse);
        assertThat(rows.count).isEqualTo(1);
    }

    /** A tenth of the speed across is damped; against the rest stands an added mass. */
    @Test
    void motionBeforeTheKickMayBeKept() {
        double length = Math.hypot(1.1, 0.5);
        island.b.velocity(0.5 / length, 1.1 / length);
        write(rod(), JointRows.X, -KICK * PULL, 0.9);
        assertThat(rows.speed(1)).isCloseTo(1, within(1e-12));
        rows.impulse[1] = -KICK * PULL / length * DRIFT * (1 - 0.9);
        assertThat(rows.residual(1)).isCloseTo(0, within(1e-9));
    }

    @Test
    void lineThatKicksFollowHasNoRowAcross() {
        write(rod(), JointRows.X, -KICK * PULL);
        island.lines.rest();
        rows.clear();
        island.jointRows.write(KICK, DRIFT);
        assertThat(rows.count).isEqualTo(1);
    }

    @Test
    void impactsDoNotMeetTheRowAcross() {
        write(rod(), JointRows.X, -KICK * PULL);
        rows.clear();
        island.jointRows.writeAtOnce();
        assertThat(rows.count).isEqualTo(1);
    }
}
