package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.RevoluteJoint;
import rigibo.backend.WeldJoint;
import rigibo.backend.contact.row.Motions;

/** Rows of joints that give way, by the tension of a row of links that sags. */
class TautPlacesTest {

    private static final double KICK = 1.0 / 120;
    private static final double DRIFT = 1.0 / 60;
    private static final double TOLERANCE = 1e-4;

    /** N. */
    private static final double LOAD = 3e4;

    /** Time in which errors decay, s. */
    private static final double DECAY = 0.5;

    private final JointedIsland island = new JointedIsland();
    private final NeutralRows rows = island.rows;

    /** Sum of the loads on the island's bodies, N. */
    private double load = LOAD;

    /** Writes the rows of the first joint, whose body A is moved by some metres and radians. */
    private void write(double missed, double turned, boolean atOnce) {
        island.pack(1, KICK);
        island.motions.data[Motions.STRIDE + Motions.DX] -= missed;
        island.motions.data[Motions.STRIDE + Motions.TURN] -= turned;
        island.poses.take(0);
        rows.clear();
        island.jointRows.taut.begin(load, TOLERANCE);
        if (atOnce) {
            island.jointRows.writeAtOnce();
        } else {
            island.jointRows.write(KICK, DRIFT);
        }
        island.jointRows.taut.rest();
    }

    /** Hinges of links of length l that are e apart carry F·√(l/8e), and e is 1e-5·l. */
    @Test
    void hingeIsATenthOfTheToleranceApartUnderTheTensionOfItsLoad() {
        island.pool.join(RevoluteJoint.at(island.a, island.b, 0.9, 0));
        write(0, 0, false);
        double length = island.jointRows.places.lengthOf(JointRows.X);
        double apart = 0.1 * TOLERANCE * length;
        write(apart, 0, false);
        double tension = LOAD * Math.sqrt(length / (8 * apart));
        rows.impulse[JointRows.X] = -KICK * tension;
        // At rest the row asks for nothing. The size is larger by what the anchors are apart.
        assertThat(rows.residual(JointRows.X)).isCloseTo(0, within(1e-4 * apart / DECAY));
        assertThat(rows.place[JointRows.X]).isCloseTo(apart, within(1e-6 * apart));
    }

    @Test
    void errorDecaysWithoutALoad() {
        island.pool.join(RevoluteJoint.at(island.a, island.b, 0.9, 0));
        write(0.01, 0, false);
        assertThat(rows.target[JointRows.X]).isCloseTo(-0.01 / (DECAY + DRIFT), within(1e-12));
        assertThat(rows.target[JointRows.Y]).isCloseTo(0, within(1e-12));
        assertThat(rows.give[JointRows.X]).isPositive();
    }

    /** A spring without load across it is as stiff as a thousand times the inertia over drift². */
    @Test
    void hingeIsStiffWithoutALoad() {
        island.pool.join(RevoluteJoint.at(island.a, island.b, 0.9, 0));
        load = 0;
        write(0, 0, false);
        double stiffness = 1e3 / (DRIFT * DRIFT * rows.response[JointRows.X]);
        double give = 1 / (KICK * (DECAY + DRIFT) * stiffness);
        assertThat(rows.give[JointRows.X]).isCloseTo(give, within(1e-12 * give));
    }

    @Test
    void anglesDoNotGiveWay() {
        island.pool.join(WeldJoint.at(island.a, island.b, 0.9, 0));
        write(0, 0.02, false);
        assertThat(rows.give[JointRows.ANGLE]).isZero();
        assertThat(rows.target[JointRows.ANGLE]).isCloseTo(-0.02 / (DECAY + DRIFT), within(1e-12));
    }

    @Test
    void limitThatIsPassedComesBack() {
        island.pool.join(RevoluteJoint.at(island.a, island.b, 0.9, 0).limits(-1, 0.5));
        write(0, 0.6, false);
        int upper = JointRows.Y + 2;
        assertThat(rows.part[upper]).isEqualTo(JointRows.UPPER);
        assertThat(rows.target[upper]).isCloseTo(0.1 / (DECAY + DRIFT), within(1e-12));
        assertThat(rows.target[upper - 1]).isNegative();
    }

    @Test
    void impactsFindJointsRigid() {
        island.pool.join(RevoluteJoint.at(island.a, island.b, 0.9, 0));
        write(0.01, 0, true);
        assertThat(rows.give[JointRows.X]).isZero();
        assertThat(rows.target[JointRows.X]).isZero();
    }
}
