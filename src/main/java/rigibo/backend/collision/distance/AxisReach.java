package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;

/**
 * The farthest point of one moving body along a fixed axis: displacement of its centre plus reach
 * of its outline.
 */
final class AxisReach {

    private final FarthestCorner farthest = new FarthestCorner();
    private Motion motion;
    private double axisX;
    private double axisY;

    /**
     * The centre's position, velocity and acceleration along the axis at the start of the motion.
     */
    private double place;

    private double velocity;
    private double acceleration;

    /**
     * The outline if turning changes its reach, else null; then {@link #outline} is the constant
     * reach, m.
     */
    private Outline turning;

    private double outline;

    /**
     * Fixes a unit axis. The pose gives the orientation of a body that does not turn; positions are
     * relative to an origin in m that both bodies share.
     */
    void fix(Motion of, Pose pose, double x, double y, double originX, double originY) {
        motion = of;
        axisX = x;
        axisY = y;
        place = x * (of.x - originX) + y * (of.y - originY);
        velocity = x * of.velocityX + y * of.velocityY;
        acceleration = x * of.accelerationX + y * of.accelerationY;
        turning = null;
        outline = of.outline.boundingRadius();
        if (!of.outline.isCentredDisc()) {
            Outline polygon = of.outline;
            turning = of.isTurning() ? polygon : null;
            outline =
                    farthest.along(
                                    polygon,
                                    pose.cos * x + pose.sin * y,
                                    pose.cos * y - pose.sin * x)
                            + polygon.radius();
        }
    }

    /** Position of the farthest point along the axis at a time in s, m. */
    double at(double time) {
        double elapsed = time - motion.startTime;
        double e1 = motion.velocityShare(elapsed);
        double e2 = motion.accelerationShare(elapsed, e1);
        double reached = turning == null ? outline : outlineAt(time);
        return place + (velocity * e1 + acceleration * e2) + reached;
    }

    private double outlineAt(double time) {
        double angle = motion.angleAt(time);
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        return farthest.along(turning, cos * axisX + sin * axisY, cos * axisY - sin * axisX)
                + turning.radius();
    }

    /**
     * Upper bound on −(d²/dt²) of the position of any point along the axis between two times, m/s².
     * Turning adds at most ω²r + |α|r.
     */
    double bend(double from, double to) {
        double straight = -motion.leastAcceleration(axisX, axisY, from);
        return turning == null ? straight : straight + motion.turningAcceleration(from, to);
    }
}
