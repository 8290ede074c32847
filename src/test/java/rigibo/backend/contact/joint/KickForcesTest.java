package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.RevoluteJoint;
import rigibo.backend.storage.JointStore;

/**
 * A hinge is pulled at in three kicks and an impact, with impulses of (3, 4) N·s times a factor.
 */
class KickForcesTest {

    private static final double KICK = 0.5;
    private static final double DT = 2;
    private static final double ROUND_OFF = 1e-12;

    private final JointedIsland island = new JointedIsland();
    private JointStore joints;
    private JointResults results;
    private KickForces forces;

    @BeforeEach
    void join() {
        island.pool.join(RevoluteJoint.at(island.a, island.b, 0.9, 0));
        island.pack(1, KICK);
        joints = island.data.jointsOrNone();
        results = new JointResults(island.data, island.packed, island.rows);
        forces = new KickForces(joints, island.packed);
        forces.begin();
        island.poses.take(0);
        island.jointRows.write(KICK, KICK);
        results.keepArms(island.poses);
    }

    private void pull(double factor) {
        island.rows.impulse[JointRows.X] = 3 * factor;
        island.rows.impulse[JointRows.Y] = 4 * factor;
    }

    private void kick(double factor) {
        pull(factor);
        forces.add(results, KICK);
    }

    private void strike(double factor) {
        pull(factor);
        results.addImpact();
    }

    private void expectPull(double newtons) {
        assertThat(joints.pull[0]).isCloseTo(newtons, within(ROUND_OFF));
    }

    @Test
    void impactsAreForcesButDoNotPull() {
        kick(1);
        strike(100);
        kick(2);
        results.tell(DT);
        expectPull(15 / DT);
        assertThat(joints.reactionX[0]).isCloseTo(3 * 103 / DT, within(1e-10));
    }

    @Test
    void firstKickTellsOfTensionThatTheRestLost() {
        kick(6);
        kick(1);
        results.tell(DT);
        forces.tellGreater();
        expectPull(30 / KICK);
    }

    @Test
    void meanOutweighsAFirstKickThatPulledLess() {
        kick(1);
        strike(7);
        kick(30);
        results.tell(DT);
        forces.tellGreater();
        expectPull(155 / DT);
    }

    @Test
    void pullThatEndedBeforeTheLastKickHasGone() {
        kick(6);
        strike(50);
        kick(0.1);
        results.tell(DT);
        forces.tellLess();
        expectPull(0.5 / KICK);
    }

    @Test
    void lastKickThatPullsMoreIsNotTheMean() {
        kick(1);
        kick(6);
        results.tell(DT);
        forces.tellLess();
        expectPull(35 / DT);
    }

    @Test
    void storedImpulsesOfImpactsAreRestored() {
        kick(1);
        island.packed.keep();
        strike(10);
        island.packed.recall();
        kick(1);
        results.tell(DT);
        expectPull(10 / DT);
    }
}
