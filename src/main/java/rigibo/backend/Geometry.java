package rigibo.backend;

import rigibo.backend.collision.distance.Distance;
import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.distance.PointAndRay;
import rigibo.backend.collision.distance.ShapeCast;
import rigibo.backend.collision.distance.TimeOfImpact;
import rigibo.backend.collision.distance.Touching;
import rigibo.backend.collision.manifold.Collider;
import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.ImpactSearch;
import rigibo.backend.setup.Require;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;

/**
 * Geometry queries on two shapes, without a pool: gap, contacts, time of impact, cast. Thread-safe.
 *
 * <pre>{@code
 * Shape box = Polygon.box(1, 1);
 * Shape disc = new Circle(0.5);
 * double gap = Geometry.gap(box, Placement.ORIGIN, disc, Placement.at(3, 0)).gap(); // 2 m
 * }</pre>
 */
public final class Geometry {

    /** Gap left at an impact, as a share of the narrower shape's width. */
    private static final double IMPACT_TOLERANCE = 1e-9;

    /** Gap within which a result of the search is tested for contact, as a share of that width. */
    private static final double MEETING = 1e-6;

    /** Most restarts of the search beside the open end of a chain. */
    private static final int MOST_LOOKS = 1000;

    /** Distance between two restarts, as a share of the narrower shape's width. */
    private static final double LOOK_AHEAD = 1e-2;

    private Geometry() {}

    /**
     * The gap between two shapes at the given poses; for compounds, between their two nearest
     * parts.
     *
     * @throws IllegalArgumentException when a shape or a pose is null
     */
    public static ShapeGap gap(Shape one, Placement at, Shape other, Placement otherAt) {
        requireShapes("gap", one, at, other, otherAt);
        Distance distance = new Distance();
        Pose pose = pose(at);
        Pose otherPose = pose(otherAt);
        ShapeGap least = null;
        for (int part = 0; part < one.parts(); part++) {
            for (int otherPart = 0; otherPart < other.parts(); otherPart++) {
                Outline outline = one.outline(part);
                distance.measure(outline, pose, other.outline(otherPart), otherPose);
                if (least == null || distance.gap < least.gap()) {
                    least = told(distance, part, otherPart);
                }
            }
        }
        return least;
    }

    private static ShapeGap told(Distance distance, int part, int otherPart) {
        return new ShapeGap(
                distance.gap,
                distance.axisX,
                distance.axisY,
                distance.pointAX,
                distance.pointAY,
                distance.pointBX,
                distance.pointBY,
                part,
                otherPart);
    }

    /**
     * The contacts between two shapes at the given poses whose gap is at most {@code reach}; for
     * compounds, one for every two parts that are so near. A shape wholly on the solid side of a
     * chain's edge has no contact with it, since an edge pushes only towards its open side.
     *
     * @param reach largest gap that is still reported, m, 0 or more
     */
    public static List<ShapeContact> contacts(
            Shape one, Placement at, Shape other, Placement otherAt, double reach) {
        requireShapes("contacts", one, at, other, otherAt);
        Require.notNegative("Geometry.contacts reach", reach, "m");
        Collider collider = new Collider();
        Manifold manifold = new Manifold();
        Pose pose = pose(at);
        Pose otherPose = pose(otherAt);
        List<ShapeContact> contacts = new ArrayList<>();
        Touching touching = new Touching();
        for (int part = 0; part < one.parts(); part++) {
            for (int otherPart = 0; otherPart < other.parts(); otherPart++) {
                Outline a = one.outline(part);
                Outline b = other.outline(otherPart);
                collider.collide(a, pose, b, otherPose, reach, manifold);
                if (manifold.count > 0 && !touching.isInMatter(a, pose, b, otherPose)) {
                    contacts.add(told(manifold, part, otherPart));
                }
            }
        }
        return contacts;
    }

    private static ShapeContact told(Manifold manifold, int part, int otherPart) {
        List<ShapeContact.Point> points = new ArrayList<>();
        for (int i = 0; i < manifold.count; i++) {
            points.add(
                    new ShapeContact.Point(
                            manifold.pointX[i], manifold.pointY[i], manifold.separation[i]));
        }
        return new ShapeContact(
                part, otherPart, manifold.normalX, manifold.normalY, List.copyOf(points));
    }

    /**
     * The first time, in s, at which two moving shapes touch while approaching, or empty if they do
     * not. Shapes that start in overlap and approach touch at time 0. A shape on the solid side of
     * a chain's edge leaves it without touching. At the time returned a gap of 10⁻⁹ of the narrower
     * shape's width is left.
     *
     * @param seconds how far to look ahead, s, 0 or more
     */
    public static OptionalDouble timeOfImpact(
            Shape one, Movement how, Shape other, Movement otherHow, double seconds) {
        requireShapes("timeOfImpact", one, how, other, otherHow);
        Require.notNegative("Geometry.timeOfImpact seconds", seconds, "s");
        TimeOfImpact search = new TimeOfImpact();
        Touching touching = new Touching();
        Pose pose = pose(how.from());
        Pose otherPose = pose(otherHow.from());
        Motion motion = motion(how);
        Motion otherMotion = motion(otherHow);
        double first =
                first(
                        one,
                        motion,
                        other,
                        otherMotion,
                        () ->
                                touching.isInMatter(
                                                motion.outline,
                                                pose,
                                                otherMotion.outline,
                                                otherPose)
                                        ? TimeOfImpact.NEVER
                                        : firstMeeting(search, motion, otherMotion, seconds));
        return first <= seconds ? OptionalDouble.of(first) : OptionalDouble.empty();
    }

    /**
     * The first time of impact found. Beside an open end of a chain the search can stop near an
     * edge in a direction in which the edge does not push; it then restarts a little later.
     */
    private static double firstMeeting(
            TimeOfImpact search, Motion motion, Motion other, double seconds) {
        boolean isEdge = motion.outline.isEdge() || other.outline.isEdge();
        double time = search.find(motion, other, 0, seconds, IMPACT_TOLERANCE, ImpactSearch.ITP);
        for (int look = 0; isEdge && look < MOST_LOOKS && time <= seconds; look++) {
            if (areTouching(motion, other, time)) {
                return time;
            }
            double next = time + lookAhead(motion, other);
            time =
                    next < seconds
                            ? search.find(
                                    motion,
                                    other,
                                    next,
                                    seconds,
                                    IMPACT_TOLERANCE,
                                    ImpactSearch.ITP)
                            : TimeOfImpact.NEVER;
        }
        return isEdge ? TimeOfImpact.NEVER : time;
    }

    private static boolean areTouching(Motion motion, Motion other, double time) {
        Pose pose = new Pose();
        Pose otherPose = new Pose();
        motion.poseAt(time, pose);
        other.poseAt(time, otherPose);
        Manifold manifold = new Manifold();
        double near = MEETING * Math.min(width(motion), width(other));
        new Collider().collide(motion.outline, pose, other.outline, otherPose, near, manifold);
        return manifold.count > 0;
    }

    private static double width(Motion motion) {
        return motion.outline.smallestWidth();
    }

    /** Time in s that the two take to move by {@link #LOOK_AHEAD} against each other. */
    private static double lookAhead(Motion motion, Motion other) {
        double speed =
                Math.abs(motion.velocityX - other.velocityX)
                        + Math.abs(motion.velocityY - other.velocityY)
                        + Math.abs(motion.spin) * motion.outline.boundingRadius()
                        + Math.abs(other.spin) * other.outline.boundingRadius();
        return LOOK_AHEAD * Math.min(width(motion), width(other)) / speed;
    }

    /**
     * Sweeps a shape along a straight line, without turning it, against a shape at rest. Returns
     * the fraction of the path, 0 to 1, at which they touch, or empty if they do not. A chain is
     * hit only from its open side.
     *
     * @param dx displacement to the right, m
     * @param dy displacement up, m
     */
    public static OptionalDouble cast(
            Shape moving, Placement from, double dx, double dy, Shape onto, Placement ontoAt) {
        requireShapes("cast", moving, from, onto, ontoAt);
        ShapeCast cast = new ShapeCast();
        Motion motion = motion(new Movement(from, dx, dy, 0));
        Motion still = motion(new Movement(ontoAt, 0, 0, 0));
        double first = first(moving, motion, onto, still, () -> cast.find(motion, still, 1));
        return first <= 1 ? OptionalDouble.of(first) : OptionalDouble.empty();
    }

    /** The least result over every two parts, whose outlines are set in the two motions. */
    private static double first(
            Shape one, Motion how, Shape other, Motion otherHow, DoubleSupplier find) {
        double first = TimeOfImpact.NEVER;
        for (int part = 0; part < one.parts(); part++) {
            for (int otherPart = 0; otherPart < other.parts(); otherPart++) {
                how.outline = one.outline(part);
                otherHow.outline = other.outline(otherPart);
                first = Math.min(first, find.getAsDouble());
            }
        }
        return first;
    }

    /** Whether a world point (m) lies in a shape or on its outline. */
    public static boolean holds(Shape shape, Placement at, double x, double y) {
        Require.present("Geometry.holds shape", shape);
        PointAndRay query = new PointAndRay();
        Pose pose = pose(Require.present("Geometry.holds placement", at));
        boolean isInside = false;
        for (int part = 0; part < shape.parts() && !isInside; part++) {
            isInside = query.holds(shape.outline(part), pose, x, y);
        }
        return isInside;
    }

    private static void requireShapes(
            String verb, Object one, Object at, Object other, Object otherAt) {
        Require.present("Geometry." + verb + " shape", one);
        Require.present("Geometry." + verb + " where it is", at);
        Require.present("Geometry." + verb + " other shape", other);
        Require.present("Geometry." + verb + " where the other is", otherAt);
    }

    static Pose pose(Placement at) {
        Pose pose = new Pose();
        pose.set(at.x(), at.y(), Angle.cos(at.angle()), Angle.sin(at.angle()));
        return pose;
    }

    private static Motion motion(Movement how) {
        Motion motion = new Motion();
        motion.x = how.from().x();
        motion.y = how.from().y();
        motion.angle = how.from().angle();
        motion.velocityX = how.velocityX();
        motion.velocityY = how.velocityY();
        motion.spin = how.angularVelocity();
        return motion;
    }
}
