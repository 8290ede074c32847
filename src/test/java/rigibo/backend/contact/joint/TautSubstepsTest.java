package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.DistanceJoint;
import rigibo.backend.JointDefinition;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.setup.Accuracy;

/** How fast bodies under tension vibrate, by the force and the arms of their joints. */
class TautSubstepsTest {

    /** N. */
    private static final double PULL = 3e4;

    private static final double KICK = 1.0 / 120;

    private JointedIsland island = new JointedIsland();

    /** Square of the fastest vibration if the first joint pulls, 1/s². */
    private double square(JointDefinition joint) {
        island.pool.join(joint);
        island.pack(1, KICK);
        island.data.jointsOrNone().pull[0] = PULL;
        return new TautSubsteps(island.data, Accuracy.GAME).square(0);
    }

    private static void assertIs(double square, double truth) {
        assertThat(square).isCloseTo(truth, within(1e-9 * truth));
    }

    @Test
    void linkIsTurnedBackByTheForceAtItsArm() {
        double arm = Math.hypot(0.6, 0.2);
        double truth = PULL * arm / island.a.inertia();
        assertIs(square(RevoluteJoint.at(island.a, island.ground, 0.9, 0)), truth);
    }

    @Test
    void beadIsDrawnBackToTheLineOfItsRod() {
        double length = Math.hypot(1.1, 0.5);
        double truth = PULL / length / island.a.mass();
        assertIs(square(DistanceJoint.rod(island.a, 0.3, 0.2, island.b, 1.4, -0.3)), truth);
    }

    /** Where nothing turns, arms do not count, and beads are drawn back all the same. */
    @Test
    void beadIsDrawnBackWhereNothingTurns() {
        island = new JointedIsland(Effects.of(new Contacts(), new Joints()));
        double truth = PULL / 0.8 / island.a.mass();
        assertIs(
                square(DistanceJoint.rope(island.a, 0.3, 0.6, island.ground, 0.3, 1.2, 0.8)),
                truth);
    }

    @Test
    void linkThatCannotTurnDoesNotVibrate() {
        island = new JointedIsland(Effects.of(new Contacts(), new Joints()));
        assertIs(square(RevoluteJoint.at(island.a, island.ground, 0.9, 0)), 0);
    }

    /** The point at which a rope holds a body goes across with the body, and by its turning. */
    @Test
    void bodyHeldBesideItsCentreIsTurnedBackToo() {
        double length = 0.8;
        double arm = 0.4;
        double across = PULL / length;
        double turning = (PULL * arm + across * arm * arm) / island.a.inertia();
        double truth = turning + across / island.a.mass();
        assertIs(
                square(DistanceJoint.rope(island.a, 0.3, 0.6, island.ground, 0.3, 1.2, length)),
                truth);
    }

    /**
     * Whether a hinge that pulls is tauter than contacts explain that pressed, N, and press now.
     */
    private boolean isUnexplained(double pressedBefore, double contactForce) {
        island.pool.join(RevoluteJoint.at(island.a, island.b, 0.9, 0));
        island.pack(1, KICK);
        island.data.jointsOrNone().pull[0] = PULL;
        island.data.islands.pairStart[1] = 1;
        island.data.islands.pairs[0] = 0;
        island.data.pairs.normalForce[0] = pressedBefore / 4;
        island.data.pairs.normalForce[1] = 3 * pressedBefore / 4;
        return new TautSubsteps(island.data, Accuracy.GAME).isUnexplained(0, 0, contactForce);
    }

    /** The limit is eight times the loads. */
    @Test
    void impactsOfTheStepExplainTension() {
        assertThat(isUnexplained(0, PULL / 8.1)).isTrue();
        assertThat(isUnexplained(0, PULL / 7.9)).isFalse();
    }

    @Test
    void whatPressedBeforeExplainsTension() {
        assertThat(isUnexplained(PULL / 8.1, 0)).isTrue();
        assertThat(isUnexplained(PULL / 7.9, 0)).isFalse();
    }
}
