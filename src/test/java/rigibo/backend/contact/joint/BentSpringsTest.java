package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.PrismaticJoint;

/** Stiff springs act with their force where a drift along straight lines leads. */
class BentSpringsTest {

    private static final double KICK = 0.02;
    private static final double DRIFT = 0.02;
    private static final double HERTZ = 50;
    private static final double RATIO = 0.3;
    private static final double ROUND_OFF = 1e-9;

    /** Each of four estimates leaves some hundredths of the error of the one before, m/s. */
    private static final double ESTIMATED = 1e-3;

    private final JointedIsland island = new JointedIsland();
    private final NeutralRows rows = island.rows;

    /** Row of the spring, written after velocities were set, before a kick. */
    private int write(double share) {
        island.poses.take(0);
        rows.clear();
        island.jointRows.write(KICK, DRIFT, false, share);
        return rows.count - 1;
    }

    private void join(JointDefinition joint) {
        island.pool.join(joint);
        island.pack(1, KICK);
    }

    /** Target of a spring that is stretched by {@code then} m after the drift. */
    private double target(int row, double then) {
        double k = island.data.joints.stiffness[0];
        double c = island.data.joints.damping[0];
        return -k * (then - DRIFT * rows.speed(row)) / (c + DRIFT * k);
    }

    private void rod() {
        join(
                DistanceJoint.rod(
                                island.a,
                                island.a.x(),
                                island.a.y(),
                                island.b,
                                island.b.x(),
                                island.b.y())
                        .spring(HERTZ, RATIO));
    }

    private double apart(double aheadX, double aheadY) {
        double x = island.b.x() - island.a.x() + aheadX;
        double y = island.b.y() - island.a.y() + aheadY;
        return Math.hypot(x, y);
    }

    /** Target of a rod whose end B moves at (−4, 9) m/s and gets another speed along it, m/s. */
    private double targetAfter(int row, double change) {
        double length = apart(0, 0);
        double x = (island.b.x() - island.a.x()) / length;
        double y = (island.b.y() - island.a.y()) / length;
        double bent = apart(DRIFT * (-4 + change * x), DRIFT * (9 + change * y));
        return target(row, bent - length - DRIFT * change);
    }

    /** An impulse as small as this changes no speed that counts. */
    private void actBefore() {
        island.packed.impulse[JointRows.SPRING] = -1e-15;
    }

    @Test
    void lengthAfterTheDriftIsThatOfBothEndsOnTheirLines() {
        island.a.velocity(1, 2);
        island.b.velocity(8, 14);
        rod();
        actBefore();
        int row = write(1);
        double then = apart(7 * DRIFT, 12 * DRIFT) - apart(0, 0);
        assertThat(rows.target[row]).isCloseTo(target(row, then), within(ROUND_OFF));
    }

    /** A kick like the last one, here twice as long, draws the ends together along the row. */
    @Test
    void lastKickIsExpectedAgain() {
        island.b.velocity(-4, 9);
        rod();
        island.packed.impulse[JointRows.SPRING] = -0.5;
        int row = write(2);
        double change = -rows.response[row];
        assertThat(rows.target[row]).isCloseTo(targetAfter(row, change), within(ROUND_OFF));
    }

    /** The slider goes on along its line while the axis turns away under it. */
    @Test
    void axisOfASliderTurns() {
        island.a.spin(5);
        island.b.velocity(3, -2);
        join(
                PrismaticJoint.along(island.a, island.b, island.b.x(), island.b.y(), 0.7)
                        .spring(HERTZ, RATIO));
        actBefore();
        int row = write(1);
        double angle = 0.7 + 5 * DRIFT;
        double armX = island.b.x() - island.a.x();
        double armY = island.b.y() - island.a.y();
        double turnedX = armX * Math.cos(5 * DRIFT) - armY * Math.sin(5 * DRIFT);
        double turnedY = armX * Math.sin(5 * DRIFT) + armY * Math.cos(5 * DRIFT);
        double x = armX + 3 * DRIFT - turnedX;
        double y = armY - 2 * DRIFT - turnedY;
        double then = x * Math.cos(angle) + y * Math.sin(angle);
        assertThat(rows.target[row]).isCloseTo(target(row, then), within(ROUND_OFF));
    }

    /**
     * Alone, a stiff spring that has not acted yet draws its ends together as far as they part by
     * going straight: the end of the drift is the end of the row's own equation.
     */
    @Test
    void firstKickIsExpectedToBendToo() {
        island.b.velocity(-4, 9);
        rod();
        int row = write(1);
        double give = rows.give[row];
        double change =
                rows.response[row]
                        * (rows.target[row] - rows.speed(row))
                        / (give + rows.response[row]);
        assertThat(rows.target[row]).isCloseTo(targetAfter(row, change), within(ESTIMATED));
    }

    @Test
    void nothingDriftsAfterTheLastKick() {
        island.b.velocity(-4, 9);
        rod();
        island.poses.take(0);
        rows.clear();
        island.jointRows.write(KICK, DRIFT, true, 1);
        assertThat(rows.target[rows.count - 1]).isCloseTo(0, within(ROUND_OFF));
    }
}
