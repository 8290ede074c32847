package rigibo.backend.flight;

import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;

/**
 * How far joined bodies may be thrown off their paths in a step by striking the stops of their
 * joint: its limits, or the end of a rope.
 */
final class JointStops {

    /**
     * A stop counts as reached from twice the time on, since loads may bring bodies to it faster.
     */
    private static final double SOONER = 2;

    private static final int REVOLUTE = JointKind.REVOLUTE.ordinal();
    private static final int DISTANCE = JointKind.DISTANCE.ordinal();

    private final Bodies bodies;
    private final JointStore joints;

    /** Vector from A's anchor to B's, m. */
    private double x;

    private double y;

    JointStops(DataStorage data) {
        bodies = data.bodies;
        joints = data.joints;
    }

    /**
     * Way (m) in dt seconds at the change of speed by an impact on a stop of a joint; 0 if none is
     * reached.
     */
    double reach(int joint, double dt) {
        double lower = joints.lower[joint];
        double upper = joints.upper[joint];
        boolean areStops =
                lower < upper
                        && (lower > Double.NEGATIVE_INFINITY || upper < Double.POSITIVE_INFINITY);
        if (!areStops) {
            return 0;
        }
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        double vx = bodies.velocityX[b] - bodies.velocityX[a];
        double vy = bodies.velocityY[b] - bodies.velocityY[a];
        double turning = turning(a, joints.armA(joint)) + turning(b, joints.armB(joint));
        double speed = Math.sqrt(vx * vx + vy * vy) + turning;
        double now = coordinate(joint, a, b);
        double rate = joints.kind[joint] == REVOLUTE ? spin(b) - spin(a) : speed;
        double gap = Math.min(now - lower, upper - now);
        boolean isReached = SOONER * Math.abs(rate) * dt > gap;
        return isReached ? (1 + joints.elasticity[joint]) * speed * dt : 0;
    }

    private double spin(int slot) {
        return bodies.turns() ? bodies.spin[slot] : 0;
    }

    private double turning(int slot, double arm) {
        return Math.abs(spin(slot)) * arm;
    }

    /** Angle of a hinge, rad; otherwise distance of the anchors, along the axis if there is one. */
    private double coordinate(int joint, int a, int b) {
        if (joints.kind[joint] == REVOLUTE) {
            double turned = bodies.angle[b] - bodies.angle[a];
            return turned + joints.axisB[joint] - joints.axisA[joint];
        }
        x = bodies.x[b] - bodies.x[a];
        y = bodies.y[b] - bodies.y[a];
        add(b, joints.anchorBX[joint], joints.anchorBY[joint], 1);
        add(a, joints.anchorAX[joint], joints.anchorAY[joint], -1);
        if (joints.kind[joint] == DISTANCE) {
            return Math.sqrt(x * x + y * y);
        }
        double angle = joints.axisA[joint] + (bodies.turns() ? bodies.angle[a] : 0);
        return x * Angle.cos(angle) + y * Angle.sin(angle);
    }

    private void add(int slot, double anchorX, double anchorY, double sign) {
        double cos = bodies.cos[slot];
        double sin = bodies.sin[slot];
        x += sign * (cos * anchorX - sin * anchorY);
        y += sign * (sin * anchorX + cos * anchorY);
    }
}
