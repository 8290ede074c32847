package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.FilledStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.JointKind;

/**
 * How far joints may lead the boxes of a chain off their paths. Each box has 1 kg, is 0.1 m high
 * and 0.8 m long, and is hinged at the ends of its neighbours.
 */
class SwayTest {

    private static final double DT = 0.1;

    private final FilledStorage storage =
            new FilledStorage(Accuracy.GAME, new Contacts(), new Rotation(), new Joints());
    private final Sway sway = new Sway(storage.data);
    private final int[] box = new int[6];
    private final int[] joint = new int[5];

    @BeforeEach
    void layChain() {
        for (int i = 0; i < box.length; i++) {
            box[i] =
                    storage.add(
                            BodyDefinition.dynamic(Polygon.box(0.8, 0.1)).at(0.8 * i, 0).mass(1));
        }
        for (int i = 0; i < joint.length; i++) {
            joint[i] = hinge(box[i], box[i + 1], 0.4, -0.4);
        }
    }

    private int hinge(int a, int b, double onA, double onB) {
        int added = storage.data.joints.add(JointKind.REVOLUTE, a, b);
        storage.data.joints.anchorAX[added] = onA;
        storage.data.joints.anchorBX[added] = onB;
        storage.data.joints.active.add(added);
        return added;
    }

    private double reach(int i) {
        sway.begin();
        return sway.reach(box[i], DT);
    }

    /** A force F at the end of a bar gives its other end the acceleration F/m + F·l·r/I. */
    @Test
    void followsFromWhatJointsDidInTheLastStep() {
        storage.bodies.velocityY[box[1]] = 100;
        storage.data.joints.reactionY[joint[0]] = 3;
        double inertia = (0.8 * 0.8 + 0.1 * 0.1) / 12;
        double turning = 3 * 0.4 / inertia * storage.bodies.sweepRadius[box[0]];
        assertThat(reach(0)).isCloseTo(2 * (3 + turning) * DT * DT / 2, within(1e-12));
    }

    /** The joints' forces balance gravity. */
    @Test
    void isNothingInAChainAtRest() {
        storage.bodies.velocityY[box[1]] = 100;
        storage.bodies.accelerationY[box[0]] = -10;
        storage.data.joints.reactionY[joint[0]] = -10;
        storage.data.joints.anchorAX[joint[0]] = 0;
        storage.data.joints.anchorBX[joint[0]] = 0;
        storage.bodies.accelerationY[box[1]] = 10;
        assertThat(reach(0)).isZero();
    }

    @Test
    void reachesBodiesTwoJointsAway() {
        storage.bodies.velocityY[box[0]] = 100;
        storage.data.joints.reactionY[joint[0]] = 3;
        assertThat(reach(2)).isCloseTo(reach(1), within(1e-12)).isGreaterThan(0);
        assertThat(reach(3)).isCloseTo(reach(1), within(1e-12));
        assertThat(reach(4)).isZero();
    }

    /** A chain as long as its span carries any force without moving. */
    @Test
    void isNoFartherThanBodiesNearbyMoveAgainstEachOther() {
        storage.data.joints.reactionY[joint[0]] = 1e6;
        storage.bodies.velocityX[box[1]] = 0.3;
        storage.bodies.velocityY[box[1]] = 0.4;
        assertThat(reach(0)).isCloseTo(2 * 0.5 * DT, within(1e-12));
        for (int slot : box) {
            storage.bodies.velocityX[slot] = 0.3;
            storage.bodies.velocityY[slot] = 0.4;
        }
        assertThat(reach(0)).isZero();
    }

    /** Doors of one frame do not lead each other. */
    @Test
    void doesNotGoThroughWhatStands() {
        int frame = storage.add(BodyDefinition.fixed(Polygon.box(1, 1)).at(0, 5));
        int door = storage.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 9).mass(1));
        storage.bodies.velocityY[box[0]] = 7;
        int first = hinge(box[0], frame, 0, 0);
        hinge(door, frame, 0, 0);
        storage.data.joints.reactionY[first] = 3;
        sway.begin();
        assertThat(sway.reach(box[0], DT)).isGreaterThan(0);
        assertThat(sway.reach(door, DT)).isZero();
    }

    @Test
    void isNothingWithoutAJoint() {
        int free = storage.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 9).mass(1));
        assertThat(sway.reach(free, DT)).isZero();
    }
}
