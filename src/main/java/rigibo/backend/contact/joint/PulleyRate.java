package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.geometry.Angle;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.JointStore;

/**
 * How fast the two ropes of a taut pulley turn about their fixed points, rad/s. A rope that is
 * drawn in almost up to its fixed point whirls about it.
 */
final class PulleyRate {

    /**
     * Factor on the rate. A rod keeps its length while it turns; a rope does not, and its energy
     * would be off by the square of the angle that it turns in a part.
     */
    static final double FINER = 8;

    /** Share of the whole rope below which the length of one side is not told. */
    private static final double SHORT = 1e-3;

    private final Bodies bodies;
    private final JointStore joints;
    private final Motions motions;

    /** Length of the rope that was measured last, m. */
    private double length;

    PulleyRate(Bodies bodies, JointStore joints, Motions motions) {
        this.bodies = bodies;
        this.joints = joints;
        this.motions = motions;
    }

    /** The rate by the stored poses and velocities. */
    double ofStored(int pulley) {
        return of(pulley, 0, 0);
    }

    /** The rate by the present ones of packed bodies; 0 is the offset of a body at rest. */
    double of(int pulley, int offsetA, int offsetB) {
        double whole = joints.parameter[JointStore.ROPE][pulley];
        double onA = ofRope(pulley, offsetA, true, SHORT * whole);
        double left = whole - length;
        double onB = ofRope(pulley, offsetB, false, SHORT * whole);
        left -= joints.parameter[JointStore.RATIO][pulley] * length;
        boolean isSlack = left > (1 - TurningRate.NEARLY) * whole;
        return isSlack ? 0 : FINER * Math.max(onA, onB);
    }

    private double ofRope(int pulley, int offset, boolean isOfA, double least) {
        int body = isOfA ? joints.bodyA[pulley] : joints.bodyB[pulley];
        double[] m = motions.data;
        boolean isPacked = offset != 0;
        double angle = bodies.angle[body] + (isPacked ? m[offset + Motions.TURN] : 0);
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        double ownX = isOfA ? joints.anchorAX[pulley] : joints.anchorBX[pulley];
        double ownY = isOfA ? joints.anchorAY[pulley] : joints.anchorBY[pulley];
        double armX = cos * ownX - sin * ownY;
        double armY = sin * ownX + cos * ownY;
        int fixed = isOfA ? JointStore.GROUND_AX : JointStore.GROUND_BX;
        double x = bodies.x[body] + armX - joints.parameter[fixed][pulley];
        double y = bodies.y[body] + armY - joints.parameter[fixed + 1][pulley];
        x += isPacked ? m[offset + Motions.DX] : 0;
        y += isPacked ? m[offset + Motions.DY] : 0;
        length = Math.sqrt(x * x + y * y);
        double spin = isPacked ? m[offset + Motions.SPIN] : bodies.spinOf(body);
        double speedX = isPacked ? m[offset + Motions.VX] : bodies.velocityX[body];
        double speedY = isPacked ? m[offset + Motions.VY] : bodies.velocityY[body];
        double vx = speedX - spin * armY;
        double vy = speedY + spin * armX;
        return Math.sqrt(vx * vx + vy * vy) / Math.max(length, least);
    }
}
