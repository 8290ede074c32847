package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.PulleyJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointSettings;

/** Ropes of a pulley turn at v/l about their fixed points. */
class PulleyRateTest {

    private static final double H = 1.0 / 240;
    private static final double ROUND_OFF = 1e-12;

    private final JointedIsland island = new JointedIsland();
    private final PulleyRate rate =
            new PulleyRate(island.data.bodies, island.data.joints, island.motions);
    private final RigidBody a = island.a;
    private final RigidBody b = island.b;

    /** Fixed points some metres above the anchors, which are {@code arm} m right of the centres. */
    private void hang(double aboveA, double aboveB, double arm) {
        island.pool.join(
                new PulleyJoint(
                        a,
                        b,
                        right(a, arm),
                        right(b, arm),
                        a.x() + arm,
                        a.y() + aboveA,
                        b.x() + arm,
                        b.y() + aboveB,
                        1,
                        aboveA + aboveB,
                        JointSettings.NONE));
        island.pack(1, H);
    }

    private static JointFrame right(RigidBody body, double arm) {
        double angle = body.angle();
        return new JointFrame(arm * Math.cos(angle), -arm * Math.sin(angle), 0);
    }

    private void expect(double perMetre) {
        assertThat(rate.ofStored(0))
                .isCloseTo(PulleyRate.FINER * perMetre, within(ROUND_OFF * PulleyRate.FINER));
    }

    @Test
    void theShorterRopeOfEquallyFastEndsTurnsFaster() {
        a.velocity(2, 0);
        b.velocity(2, 0);
        hang(0.25, 3, 0);
        expect(2 / 0.25);
        a.velocity(0, 0);
        expect(2 / 3.0);
    }

    @Test
    void anEndOnAnArmMovesWithTheSpin() {
        a.spin(5);
        hang(2, 3, 0.4);
        expect(5 * 0.4 / 2);
    }

    /** A body 10 cm nearer to its fixed point leaves a tenth of a rope of one metre slack. */
    @Test
    void aSlackRopeDoesNotTurn() {
        a.velocity(2, 0);
        hang(0.5, 0.5, 0);
        expect(2 / 0.5);
        a.moveTo(a.x(), a.y() + 0.1, a.angle());
        expect(0);
    }

    @Test
    void packedBodiesAreTakenWhereTheyAreNow() {
        a.velocity(2, 0);
        hang(0.5, 3, 0);
        int at = Motions.STRIDE;
        island.motions.data[at + Motions.DY] = 0.25;
        island.motions.data[2 * at + Motions.DY] = -0.25;
        island.motions.data[at + Motions.VX] = 3;
        assertThat(rate.of(0, at, 2 * at))
                .isCloseTo(PulleyRate.FINER * 3 / 0.25, within(ROUND_OFF * PulleyRate.FINER));
    }

    /** Its length is not told below a thousandth of the rope. */
    @Test
    void anEndAtItsFixedPointTurnsAsFastAsAtTheShortestLength() {
        a.velocity(2, 0);
        hang(0, 3, 0);
        expect(2 / 0.003);
    }
}
