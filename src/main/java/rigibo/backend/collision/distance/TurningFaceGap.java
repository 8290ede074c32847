package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;

/**
 * The gap in front of a face, along a normal that turns with the face's body (the carrier). Where a
 * long face sweeps towards a body near its middle, its end moves much faster along the present
 * normal than the face does near that body. With an axis fixed in the world the search would
 * advance in tiny steps.
 *
 * <p>With u the normal, ω and α the carrier's angular velocity and acceleration, and q a corner of
 * the other body relative to the carrier's centre, a gap is u·q minus a constant, and (u·q)'' =
 * u·q'' + 2ω u⊥·q' + α u⊥·q − ω² u·q.
 */
final class TurningFaceGap implements GapAlong {

    private final FarthestCorner farthest = new FarthestCorner();
    private Motion carrier;
    private Motion other;

    /** The normal in the carrier's frame, and the carrier's reach along it, m. */
    private double normalX;

    private double normalY;
    private double reach;

    /** The other body's outline; null for a disc centred on its centre of mass. */
    private Outline polygon;

    /** Distance of the centres and gap at the time when the face was fixed, m. */
    private double apart;

    private double gap;

    /**
     * Fixes the face of a polygon by its outward unit normal in the world, at the time of the two
     * poses; {@code now} is the gap then, m.
     */
    void fix(Motion of, Pose pose, Motion against, Pose otherPose, double x, double y, double now) {
        carrier = of;
        other = against;
        gap = now;
        normalX = pose.cos * x + pose.sin * y;
        normalY = pose.cos * y - pose.sin * x;
        reach = farthest.along(of.outline, normalX, normalY) + of.outline.radius();
        polygon = against.outline.isCentredDisc() ? null : against.outline;
        double dx = otherPose.x - pose.x;
        double dy = otherPose.y - pose.y;
        apart = Math.sqrt(dx * dx + dy * dy);
    }

    @Override
    public double at(double time) {
        double angle = carrier.angleAt(time);
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        double x = cos * normalX - sin * normalY;
        double y = sin * normalX + cos * normalY;
        double between =
                x * (other.x - carrier.x)
                        + y * (other.y - carrier.y)
                        + (other.movedAlong(x, y, time) - carrier.movedAlong(x, y, time));
        return between - reach - otherReach(angle, time);
    }

    /** Reach of the other body towards the face, m. */
    private double otherReach(double angle, double time) {
        if (polygon == null) {
            return other.outline.boundingRadius();
        }
        double turned = angle - other.angleAt(time);
        double cos = Angle.cos(turned);
        double sin = Angle.sin(turned);
        return farthest.along(
                        polygon, -(cos * normalX - sin * normalY), -(sin * normalX + cos * normalY))
                + polygon.radius();
    }

    @Override
    public double bend(double from, double to) {
        double interval = to - from;
        double acceleration = other.accelerationAgainst(carrier, from);
        double speed = other.speedAgainst(carrier, from) + acceleration * interval;
        double spin = carrier.mostSpin(from, to);
        double radius = 0;
        if (polygon != null) {
            radius = other.outline.boundingRadius();
            acceleration += other.turningAcceleration(from, to);
            speed += other.mostSpin(from, to) * radius;
        }
        double far = apart + speed * interval + radius;
        // The last term reduces the curvature while the corner is in front of the carrier's centre.
        double behind = (speed + spin * far) * interval - gap - reach;
        return acceleration
                + 2 * spin * speed
                + Math.abs(carrier.angularAcceleration) * far
                + spin * spin * Math.max(0, behind);
    }
}
