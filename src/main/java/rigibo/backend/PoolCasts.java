package rigibo.backend;

import rigibo.backend.broadphase.FixtureSearch;
import rigibo.backend.broadphase.RayWalk;
import rigibo.backend.collision.distance.Distance;
import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.distance.PointAndRay;
import rigibo.backend.collision.distance.ShapeCast;
import rigibo.backend.collision.distance.Touching;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Found;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Queries of a state with a shape, for the nearest point, and for all bodies along a ray. */
final class PoolCasts {

    private final Queried state;
    private final Bodies bodies;
    private final PoolQueries queries;
    private final Pose pose = new Pose();
    private final Pose otherPose = new Pose();
    private final PointAndRay pointAndRay = new PointAndRay();
    private final Touching touching = new Touching();
    private final Distance distance = new Distance();
    private final ShapeCast shapeCast = new ShapeCast();
    private final Motion moving = new Motion();
    private final Motion standing = new Motion();
    private final Aabb box = new Aabb();

    PoolCasts(Queried state, PoolQueries queries) {
        this.state = state;
        this.queries = queries;
        bodies = state.bodies();
    }

    /** All bodies that a ray enters, each once, in the order along the ray. */
    List<RayHit> rayCastAll(double fromX, double fromY, double toX, double toY, Filter filter) {
        requireWay("rayCastAll", fromX, fromY, toX, toY);
        Require.present("Pool.rayCastAll filter", filter);
        box.set(0, 0, 0, 0);
        List<RayHit> hits = new ArrayList<>();
        Found found = onTheWay(box, fromX, fromY, toX, toY);
        for (int i = 0; i < found.count; i++) {
            int slot = found.numbers[i];
            int body = place(slot);
            double at = pointAndRay.enters(bodies.outline[slot], pose, fromX, fromY, toX, toY);
            if (at <= 1 && queries.meets(slot, filter) && !queries.holds(body, fromX, fromY)) {
                hits.add(hit(slot, fromX, fromY, toX - fromX, toY - fromY, at));
            }
        }
        return firstOfEach(hits);
    }

    private RayHit hit(int slot, double x, double y, double dx, double dy, double at) {
        return new RayHit(
                state.handle(bodies.bodyOf(slot)),
                bodies.partOf(slot),
                x + at * dx,
                y + at * dy,
                pointAndRay.normalX,
                pointAndRay.normalY,
                at);
    }

    private List<RayHit> firstOfEach(List<RayHit> hits) {
        hits.sort(
                Comparator.comparingDouble(RayHit::fraction)
                        .thenComparingInt(hit -> state.place(hit.body()))
                        .thenComparingInt(RayHit::part));
        Set<RigidBody> met = new LinkedHashSet<>();
        hits.removeIf(hit -> !met.add(hit.body()));
        return hits;
    }

    /** The first body that a shape hits along a straight line. */
    Optional<RayHit> cast(Shape shape, Placement from, double dx, double dy, Filter filter) {
        Require.present("Pool.cast shape", shape);
        Require.present("Pool.cast from", from);
        Require.present("Pool.cast filter", filter);
        Require.finite("Pool.cast dx", dx, "m");
        Require.finite("Pool.cast dy", dy, "m");
        shape.bounds(0, 0, Angle.cos(from.angle()), Angle.sin(from.angle()), box);
        Found found = onTheWay(box, from.x(), from.y(), from.x() + dx, from.y() + dy);
        moving.x = from.x();
        moving.y = from.y();
        moving.angle = from.angle();
        moving.velocityX = dx;
        moving.velocityY = dy;
        int met = -1;
        int metBy = 0;
        double first = 1;
        for (int i = 0; i < found.count; i++) {
            int slot = found.numbers[i];
            if (!queries.meets(slot, filter)) {
                continue;
            }
            standing.takePose(bodies, bodies.bodyOf(slot));
            standing.outline = bodies.outline[slot];
            for (int part = 0; part < shape.parts(); part++) {
                moving.outline = shape.outline(part);
                double time = shapeCast.find(moving, standing, 1);
                if (time < first || time == first && isBefore(slot, met)) {
                    first = time;
                    met = slot;
                    metBy = part;
                }
            }
        }
        return met < 0 ? Optional.empty() : Optional.of(touch(shape, metBy, met, first));
    }

    /** Whether a body was added before another; true if there is no other yet. */
    private boolean isBefore(int slot, int other) {
        return other < 0 || order(slot) < order(other);
    }

    private int order(int slot) {
        return state.place(state.handle(bodies.bodyOf(slot)));
    }

    private RayHit touch(Shape shape, int part, int slot, double fraction) {
        moving.poseAt(fraction, otherPose);
        int body = place(slot);
        distance.measure(shape.outline(part), otherPose, bodies.outline[slot], pose);
        return new RayHit(
                state.handle(body),
                bodies.partOf(slot),
                distance.pointBX,
                distance.pointBY,
                -distance.axisX,
                -distance.axisY,
                fraction);
    }

    /** The shapes whose fixtures may overlap a box swept from one point to another. */
    private Found onTheWay(Aabb carried, double fromX, double fromY, double toX, double toY) {
        FixtureSearch search = state.search();
        if (search == null) {
            return queries.near(
                    new Aabb(
                            Math.min(fromX, toX) + carried.minX,
                            Math.min(fromY, toY) + carried.minY,
                            Math.max(fromX, toX) + carried.maxX,
                            Math.max(fromY, toY) + carried.maxY));
        }
        Found found = new Found();
        RayWalk walk = search.walk(carried, fromX, fromY, toX, toY);
        for (int slot = walk.next(1); slot != RayWalk.END; slot = walk.next(1)) {
            found.add(slot);
        }
        found.sort();
        return found;
    }

    /** The bodies that a shape overlaps or touches. */
    Set<RigidBody> overlapping(Shape shape, Placement at, Filter filter) {
        Require.present("Pool.overlapping shape", shape);
        Require.present("Pool.overlapping placement", at);
        Require.present("Pool.overlapping filter", filter);
        double cos = Angle.cos(at.angle());
        double sin = Angle.sin(at.angle());
        otherPose.set(at.x(), at.y(), cos, sin);
        shape.bounds(at.x(), at.y(), cos, sin, box);
        Set<RigidBody> inside = new LinkedHashSet<>();
        Found found = queries.near(box);
        for (int i = 0; i < found.count; i++) {
            int slot = found.numbers[i];
            int body = place(slot);
            if (queries.meets(slot, filter) && touches(shape, slot)) {
                inside.add(state.handle(body));
            }
        }
        return inside;
    }

    private boolean touches(Shape shape, int slot) {
        boolean touches = false;
        for (int part = 0; part < shape.parts() && !touches; part++) {
            touches =
                    touching.areTouching(
                            shape.outline(part), otherPose, bodies.outline[slot], pose);
        }
        return touches;
    }

    /** The point of any body that is nearest to a point, within a distance in m. */
    Optional<NearestPoint> nearest(double x, double y, double within, Filter filter) {
        Require.finite("Pool.nearest x", x, "m");
        Require.finite("Pool.nearest y", y, "m");
        Require.notNegative("Pool.nearest within", within, "m");
        Require.present("Pool.nearest filter", filter);
        box.set(x - within, y - within, x + within, y + within);
        NearestPoint nearest = null;
        Found found = queries.near(box);
        for (int i = 0; i < found.count; i++) {
            int slot = found.numbers[i];
            RigidBody body = state.handle(place(slot));
            double away = pointAndRay.nearest(bodies.outline[slot], pose, x, y);
            boolean isNearer =
                    nearest == null
                            ? away <= within
                            : away < nearest.distance()
                                    || away == nearest.distance()
                                            && state.place(body) < state.place(nearest.body());
            if (isNearer && queries.meets(slot, filter)) {
                double px = pointAndRay.pointX;
                double py = pointAndRay.pointY;
                nearest = new NearestPoint(body, bodies.partOf(slot), px, py, away);
            }
        }
        return Optional.ofNullable(nearest);
    }

    /** Sets the pose to that of a shape's body and returns the body's slot. */
    private int place(int slot) {
        int body = bodies.bodyOf(slot);
        pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
        return body;
    }

    static void requireWay(String verb, double fromX, double fromY, double toX, double toY) {
        Require.finite("Pool." + verb + " fromX", fromX, "m");
        Require.finite("Pool." + verb + " fromY", fromY, "m");
        Require.finite("Pool." + verb + " toX", toX, "m");
        Require.finite("Pool." + verb + " toY", toY, "m");
    }
}
