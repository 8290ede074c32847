package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;

/**
 * How fast joined bodies turn about their joints, rad/s. Bodies drift along straight lines between
 * two kicks: the end of a rod that turns by more than a radian in a drift is out of reach of any
 * kick along the rod.
 */
final class TurningRate {

    /** Share of its length from which on a rope counts as taut. */
    static final double NEARLY = 0.98;

    private final Bodies bodies;
    private final JointStore joints;
    private final Islands islands;
    private final Motions motions;
    private final PackedJoints packed;
    private final PulleyRate pulleys;

    TurningRate(DataStorage data, Motions motions, PackedJoints packed) {
        bodies = data.bodies;
        joints = data.jointsOrNone();
        islands = data.islands;
        this.motions = motions;
        this.packed = packed;
        pulleys = new PulleyRate(bodies, joints, motions);
    }

    /** The fastest rate in an island by the stored velocities. */
    double ofStored(int island) {
        double most = 0;
        for (int i = islands.jointStart[island]; i < islands.jointStart[island + 1]; i++) {
            int joint = islands.joints[i];
            int a = joints.bodyA[joint];
            int b = joints.bodyB[joint];
            double x = bodies.velocityX[b] - bodies.velocityX[a];
            double y = bodies.velocityY[b] - bodies.velocityY[a];
            most = Math.max(most, ofSpin(joint, a, b, spin(a), spin(b)));
            most = Math.max(most, ofLine(joint, a, b, x, y, 0, 0));
            most = Math.max(most, isPulley(joint) ? pulleys.ofStored(joint) : 0);
        }
        return most;
    }

    private boolean isPulley(int joint) {
        return joints.kind[joint] == JointKind.PULLEY.ordinal();
    }

    private double spin(int body) {
        return bodies.turns() ? bodies.spin[body] : 0;
    }

    /** The fastest rate in the packed island by its present velocities. */
    double ofPacked() {
        double[] m = motions.data;
        double most = 0;
        for (int i = 0; i < packed.count; i++) {
            int joint = packed.slot[i];
            int a = packed.offsetA[i];
            int b = packed.offsetB[i];
            int bodyA = joints.bodyA[joint];
            int bodyB = joints.bodyB[joint];
            double spinA = m[a + Motions.SPIN];
            double spinB = m[b + Motions.SPIN];
            most = Math.max(most, ofSpin(joint, bodyA, bodyB, spinA, spinB));
            double x = m[b + Motions.VX] - m[a + Motions.VX];
            double y = m[b + Motions.VY] - m[a + Motions.VY];
            double wayX = m[b + Motions.DX] - m[a + Motions.DX];
            double wayY = m[b + Motions.DY] - m[a + Motions.DY];
            most = Math.max(most, ofLine(joint, bodyA, bodyB, x, y, wayX, wayY));
            most = Math.max(most, isPulley(joint) ? pulleys.of(joint, a, b) : 0);
        }
        return most;
    }

    private double ofSpin(int joint, int a, int b, double spinA, double spinB) {
        return Math.max(ofSpin(a, joints.armA(joint), spinA), ofSpin(b, joints.armB(joint), spinB));
    }

    /** The pull on the axis of a turning body tends to turn it back at ω·r·√(m/I). */
    private double ofSpin(int body, double arm, double spin) {
        if (spin == 0 || !bodies.isDynamic(body)) {
            return 0;
        }
        double ratio = bodies.inverseInertiaOf(body) / bodies.inverseMass[body];
        return Math.abs(spin) * Math.min(1, arm * Math.sqrt(ratio));
    }

    /**
     * The rate of a rod, rope or spring between bodies that part at x, y m/s and have moved apart
     * by a way in m; 0 for a rope that is slack, and for a spring that draws together to a point.
     */
    private double ofLine(int joint, int a, int b, double x, double y, double wayX, double wayY) {
        if (joints.kind[joint] != JointKind.DISTANCE.ordinal()) {
            return 0;
        }
        double dx = bodies.x[b] - bodies.x[a] + wayX;
        double dy = bodies.y[b] - bodies.y[a] + wayY;
        double apart = length(dx, dy);
        double arms = joints.armA(joint) + joints.armB(joint);
        double line = joints.tautLength(joint);
        if (joints.stiffness[joint] > 0) {
            // Along itself a spring may change its length as fast as it likes.
            double across = apart > 0 ? Math.abs(dx * y - dy * x) / apart : 0;
            return line > 0 ? across / (Math.max(apart, line) + arms) : 0;
        }
        boolean isSlack = joints.isRope(joint) && apart + arms < NEARLY * line;
        return isSlack || !(line + arms > 0) ? 0 : length(x, y) / (line + arms);
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }
}
