package rigibo.backend.collision;

import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;

/** How far one moving body reaches along a fixed axis: its centre's way plus its outline. */
final class AxisReach {

    private final FarthestCorner farthest = new FarthestCorner();
    private Motion motion;
    private double axisX;
    private double axisY;

    /** The centre along the axis at the motion's own start, its velocity and acceleration. */
    private double place;

    private double velocity;
    private double acceleration;

    /**
     * The outline where it turns, and turning moves it, else null: the outline then stays as it is.
     */
    private Outline turning;

    private double outline;

    /**
     * Fixes a unit axis. The pose is the body's at any time in question; places are measured from
     * an origin in m that both bodies share.
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

    /** The farthest point along the axis at a time in s, m. */
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
     * A bound from above on −(d²/dt²) of any point's place along the axis between two times, m/s²:
     * how strongly the way can bend back. Turning adds at most ω²r + |α|r.
     */
    double bend(double from, double to) {
        double straight = -motion.leastAcceleration(axisX, axisY, from);
        return turning == null ? straight : straight + motion.turningAcceleration(from, to);
    }
}
