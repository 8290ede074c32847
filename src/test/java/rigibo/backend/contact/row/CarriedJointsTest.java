package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.GearJoint;
import rigibo.backend.Joint;
import rigibo.backend.JointDefinition;
import rigibo.backend.MouseJoint;
import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.RevoluteJoint;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.DataStorage;

/** Islands carried by joints: {@link CarriedFrame}. */
class CarriedJointsTest {

    private final Pool pool =
            new Pool(Effects.of(new Contacts(), new Rotation(), new Joints()), Accuracy.GAME);
    private final DataStorage data = PoolStorage.of(pool);
    private final Motions motions = new Motions(true);
    private final CarriedFrame frame = new CarriedFrame(data, motions);
    private final RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)));
    private final RigidBody other = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(1, 0));

    private RigidBody carrier(double x, double vx, double vy) {
        return pool.add(BodyDefinition.kinematic(Polygon.box(1, 1)).at(x, 1).velocity(vx, vy));
    }

    /** Enters the frame of an island of two boxes and of the joints from a number on. */
    private void enter(int from, int jointCount) {
        data.islands.count = 1;
        data.islands.bodies[0] = 0;
        data.islands.bodies[1] = 1;
        data.islands.bodyStart[1] = 2;
        data.islands.reserveJoints(1, jointCount);
        for (int i = 0; i < jointCount; i++) {
            data.islands.joints[i] = from + i;
        }
        data.islands.jointStart[1] = jointCount;
        frame.enter(0);
    }

    private static JointDefinition hinge(RigidBody a, RigidBody b) {
        return RevoluteJoint.at(a, b, 0.5, 0.5);
    }

    @ParameterizedTest
    @CsvSource({"true, false", "false, false", "true, true", "false, true"})
    void carriersMayBeAtEitherEndOfAnyJoint(boolean isFirst, boolean isLast) {
        RigidBody carrier = carrier(0, 3, -2);
        if (isLast) {
            pool.join(hinge(box, other));
        }
        pool.join(isFirst ? hinge(carrier, box) : hinge(box, carrier));
        enter(0, isLast ? 2 : 1);
        assertThat(motions.frameX).isEqualTo(3);
        assertThat(motions.frameY).isEqualTo(-2);
    }

    @Test
    void carriersOfAllJointsHaveToMoveAlike() {
        pool.join(hinge(carrier(0, 3, -2), box));
        pool.join(hinge(other, carrier(1, 3, -1)));
        enter(0, 2);
        assertThat(motions.isInWorld()).isTrue();
        pool.join(hinge(carrier(2, 3, -2), box));
        enter(1, 1);
        assertThat(motions.frameY).isEqualTo(-1);
    }

    /** A mouse joint holds a place in the world. */
    @Test
    void handsHoldOnToTheWorld() {
        RigidBody carrier = carrier(0, 3, -2);
        pool.join(hinge(carrier, box));
        pool.join(MouseJoint.of(carrier, box, 0, 0));
        enter(0, 2);
        assertThat(motions.isInWorld()).isTrue();
        enter(0, 1);
        assertThat(motions.isInWorld()).isFalse();
    }

    /** Gears also push on the bases of both joints. */
    @ParameterizedTest
    @CsvSource({"-2, true", "-1, false"})
    void basesOfGearsCarryAsWell(double speed, boolean isCarried) {
        Joint first = pool.join(hinge(carrier(0, 3, -2), box));
        Joint second = pool.join(hinge(carrier(1, 3, speed), other));
        pool.join(GearJoint.of(first, second, 2));
        enter(2, 1);
        assertThat(motions.isInWorld()).isEqualTo(!isCarried);
    }
}
