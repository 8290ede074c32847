package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.WeldJoint;
import rigibo.backend.contact.row.Motions;

/** Rates of bodies that turn about hinges, and of lines, against v/l and ω·r·√(m/I). */
class TurningRateTest {

    private static final double H = 1.0 / 240;
    private static final double ROUND_OFF = 1e-12;

    private final JointedIsland island = new JointedIsland();
    private final TurningRate rate = new TurningRate(island.data, island.motions, island.packed);
    private final RigidBody a = island.a;
    private final RigidBody b = island.b;

    private void join(JointDefinition joint) {
        island.pool.join(joint);
        island.pack(1, H);
    }

    /** Expects a rate of stored and of packed velocities. */
    private void expect(double expected) {
        assertThat(rate.ofStored(0)).isCloseTo(expected, within(ROUND_OFF));
        island.pack(1, H);
        assertThat(rate.ofPacked()).isCloseTo(expected, within(ROUND_OFF));
    }

    private void rod() {
        join(DistanceJoint.rod(a, a.x(), a.y(), b, b.x(), b.y()));
    }

    private double apart() {
        return Math.hypot(b.x() - a.x(), b.y() - a.y());
    }

    @Test
    void aRodTurnsAsFastAsItsEndsMoveOverItsLength() {
        rod();
        a.velocity(1, -2);
        b.velocity(4, 2);
        expect(5 / apart());
    }

    @Test
    void whatSpinsAtTheEndOfARodDoesNotTurnIt() {
        rod();
        b.spin(50);
        expect(0);
    }

    @Test
    void aSlackRopeDoesNotTurn() {
        b.velocity(0, 3);
        join(DistanceJoint.rope(a, a.x(), a.y(), b, b.x(), b.y(), 1.05 * apart()));
        expect(0);
    }

    @Test
    void aTautRopeTurnsLikeARod() {
        b.velocity(0, 3);
        join(DistanceJoint.rope(a, a.x(), a.y(), b, b.x(), b.y(), 1.01 * apart()));
        expect(3 / (1.01 * apart()));
    }

    @Test
    void aRopeThatBecameTautOnTheWayTurns() {
        double length = 1.2 * apart();
        join(DistanceJoint.rope(a, a.x(), a.y(), b, b.x(), b.y(), length));
        int at = 2 * Motions.STRIDE;
        island.motions.data[at + Motions.VX] = 3;
        assertThat(rate.ofPacked()).isEqualTo(0);
        island.motions.data[at + Motions.DX] = b.x() - a.x();
        assertThat(rate.ofPacked()).isCloseTo(3 / length, within(ROUND_OFF));
    }

    /** Boxes of 1 × ½ m have I = m·(1 + ¼)/12. */
    @Test
    void aHingeAtACornerTurnsAtTheBodysSpin() {
        join(RevoluteJoint.at(a, b, b.worldX(0.5, 0.25), b.worldY(0.5, 0.25)));
        b.spin(-7);
        expect(7);
    }

    @Test
    void aHingeNearTheCentreTurnsBySlower() {
        join(RevoluteJoint.at(island.ground, b, b.worldX(0.1, 0), b.worldY(0.1, 0)));
        b.spin(7);
        expect(7 * 0.1 / Math.sqrt(1.25 / 12));
    }

    @Test
    void aWheelOnItsAxleDoesNotTurnAboutIt() {
        join(RevoluteJoint.at(island.ground, b, b.x(), b.y()));
        b.spin(70);
        expect(0);
    }

    @Test
    void theFastestOfBothBodiesCounts() {
        join(WeldJoint.at(a, b, 0.9, 0));
        a.spin(3);
        double slow = rate.ofStored(0);
        a.spin(6);
        expect(2 * slow);
        b.spin(1);
        expect(2 * slow);
    }

    private void spring() {
        join(DistanceJoint.rod(a, a.x(), a.y(), b, b.x(), b.y()).spring(5, 0));
    }

    /** 3 m/s across the line, and anything along it. */
    @Test
    void aSpringTurnsAsFastAsItsEndsMoveAcrossIt() {
        spring();
        double x = (b.x() - a.x()) / apart();
        double y = (b.y() - a.y()) / apart();
        b.velocity(7 * x - 3 * y, 7 * y + 3 * x);
        expect(3 / apart());
    }

    /** Its force is as large in any direction, so that none has to be followed. */
    @Test
    void aSpringThatDrawsTogetherToAPointDoesNotTurn() {
        join(DistanceJoint.rod(a, a.x(), a.y(), b, b.x(), b.y()).length(0).spring(5, 0));
        b.velocity(2, 3);
        expect(0);
    }
}
