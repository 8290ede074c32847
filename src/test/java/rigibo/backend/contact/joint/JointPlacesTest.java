package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.DistanceJoint;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.contact.row.Motions;

/** Places and sizes of joints by the poses of their bodies. */
class JointPlacesTest {

    private static final double KICK = 0.01;

    /** A few roundings of places within 4 m. */
    private static final double ROUND_OFF = 1e-14;

    private final JointedIsland island = new JointedIsland();
    private final JointPlaces places = island.jointRows.places;

    private void write() {
        island.pack(1, KICK);
        island.poses.take(0);
        island.rows.clear();
        island.jointRows.write(KICK, KICK);
    }

    private void move(int entry, double x, double y) {
        int at = entry * Motions.STRIDE;
        island.motions.data[at + Motions.DX] += x;
        island.motions.data[at + Motions.DY] += y;
        island.poses.take(0);
        places.measureAnew();
    }

    /** From (0.3, 0.2) to (1.4, -0.3) and then to (1.7, -0.7). */
    @Test
    void aRodIsOffByWhatItsAnchorsAreApart() {
        island.pool.join(DistanceJoint.rod(island.a, 0.3, 0.2, island.b, 1.4, -0.3));
        write();
        double length = Math.sqrt(1.1 * 1.1 + 0.5 * 0.5);
        assertThat(places.of(0)).isCloseTo(0, within(ROUND_OFF));
        assertThat(places.along(0)).isCloseTo(length, within(ROUND_OFF));
        move(2, 0.3, -0.4);
        double longer = Math.sqrt(1.4 * 1.4 + 0.9 * 0.9);
        assertThat(places.of(0)).isCloseTo(longer - length, within(ROUND_OFF));
        assertThat(places.size(0)).isCloseTo(1.4 + 0.9, within(ROUND_OFF));
    }

    /** Half the width of a box is less than the arms of a hinge a metre from both. */
    @Test
    void aHingeIsAsLargeAsTheArmsOfItsMovableBodies() {
        island.pool.join(RevoluteJoint.at(island.ground, island.a, 0.3, 1.2));
        write();
        assertThat(places.size(0)).isCloseTo(1, within(ROUND_OFF));
        move(1, 0, 0.25);
        assertThat(places.of(1)).isCloseTo(0.25, within(ROUND_OFF));
        assertThat(places.size(1)).isCloseTo(1.25, within(ROUND_OFF));
    }

    @Test
    void poseIsMeasuredOnceUntilItIsDiscarded() {
        island.pool.join(RevoluteJoint.at(island.ground, island.a, 0.3, 1.2));
        write();
        places.of(1);
        island.motions.data[Motions.STRIDE + Motions.DY] = 1;
        island.poses.take(0);
        assertThat(places.of(1)).isCloseTo(0, within(ROUND_OFF));
        places.measureAnew();
        assertThat(places.of(1)).isCloseTo(1, within(ROUND_OFF));
    }
}
