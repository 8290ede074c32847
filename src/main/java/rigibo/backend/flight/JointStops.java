package rigibo.backend.flight;

import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointReading;
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

    private final Bodies bodies;
    private final JointStore joints;
    private final JointReading reading;

    JointStops(DataStorage data) {
        bodies = data.bodies;
        joints = data.joints;
        reading = new JointReading(bodies, joints);
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
        double now = reading.coordinate(joint);
        double rate = joints.kind[joint] == REVOLUTE ? bodies.spinOf(b) - bodies.spinOf(a) : speed;
        double gap = Math.min(now - lower, upper - now);
        boolean isReached = SOONER * Math.abs(rate) * dt > gap;
        return isReached ? (1 + joints.elasticity[joint]) * speed * dt : 0;
    }

    private double turning(int slot, double arm) {
        return Math.abs(bodies.spinOf(slot)) * arm;
    }
}
