package rigibo.backend.flight;

import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointReading;
import rigibo.backend.storage.JointStore;

/**
 * How far springs and motors of joints may draw bodies off their paths in a step. A light body that
 * was held against a strong spring goes far in the step in which it is let go.
 */
final class JointDrives {

    private final Bodies bodies;
    private final JointStore joints;
    private final JointReading reading;

    JointDrives(DataStorage data) {
        bodies = data.bodies;
        joints = data.joints;
        reading = new JointReading(bodies, joints);
    }

    /** Way that the spring and the motor of a joint give one of its bodies in dt seconds, m. */
    double way(int joint, int slot, double dt) {
        boolean isPushed = bodies.isDynamic(slot) && joints.hasRows(bodies, joint);
        return isPushed ? bySpring(joint, slot, dt) + byMotor(joint, slot, dt) : 0;
    }

    /** A spring draws a body no farther than to the other side of its rest. */
    private double bySpring(int joint, int slot, double dt) {
        JointKind kind = joints.kindOf(joint);
        boolean isHand = kind == JointKind.MOUSE;
        if (!(joints.stiffness[joint] > 0) || isHand && slot == joints.bodyA[joint]) {
            return 0;
        }
        boolean turns = kind == JointKind.REVOLUTE || kind == JointKind.WELD;
        double strain = Math.abs(reading.strain(joint));
        double pull = joints.stiffness[joint] * strain;
        double force =
                isHand ? Math.min(pull, joints.parameter[JointStore.MOST_FORCE][joint]) : pull;
        double gained = force * inverse(slot, turns) * dt * dt / 2;
        return Math.min(gained, 2 * strain) * lever(joint, slot, turns);
    }

    /** A motor makes a body no faster than its target speed. */
    private double byMotor(int joint, int slot, double dt) {
        if (!(joints.motorMost[joint] > 0)) {
            return 0;
        }
        JointKind kind = joints.kindOf(joint);
        boolean turns = kind == JointKind.REVOLUTE || kind == JointKind.WHEEL;
        double now =
                turns
                        ? bodies.spinOf(joints.bodyB[joint]) - bodies.spinOf(joints.bodyA[joint])
                        : reading.speed(joint);
        double lacks = Math.abs(joints.motorSpeed[joint] - now);
        double gained = joints.motorMost[joint] * inverse(slot, turns) * dt / 2;
        return Math.min(gained, lacks) * dt * lever(joint, slot, turns);
    }

    /** Inverse mass, 1/kg, or inverse inertia, 1/(kg·m²). */
    private double inverse(int slot, boolean turns) {
        return turns ? bodies.inverseInertiaOf(slot) : bodies.inverseMass[slot];
    }

    /** Way of a body's outline in m for each unit that its joint moves it, a metre or a radian. */
    private double lever(int joint, int slot, boolean turns) {
        boolean isA = slot == joints.bodyA[joint];
        double arm = isA ? joints.armA(joint) : joints.armB(joint);
        return turns ? arm + bodies.boundingRadius[slot] : 1;
    }
}
