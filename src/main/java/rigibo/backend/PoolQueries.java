package rigibo.backend;

import rigibo.backend.broadphase.FixtureSearch;
import rigibo.backend.collision.distance.PointAndRay;
import rigibo.backend.collision.distance.Touching;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Pairs;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;

/** Queries of a state by point, ray and box. */
final class PoolQueries {

    /** Side in m of the box used in place of one without an area. */
    private static final double LEAST_SIDE = 1e-9;

    private final Queried state;
    private final Bodies bodies;
    private final Found near = new Found();
    private final Aabb bounds = new Aabb();
    private final Aabb box = new Aabb();
    private final Pose pose = new Pose();
    private final Pose areaPose = new Pose();
    private final PointAndRay pointAndRay = new PointAndRay();
    private final RayCast ray;
    private final Touching touching = new Touching();

    PoolQueries(Queried state) {
        this.state = state;
        ray = new RayCast(state, this);
        bodies = state.bodies();
    }

    /**
     * Whether two bodies touched. Both lists of pairs are gone through side by side, up to the end
     * of the shorter one: that of a box, where the other is a floor under a thousand.
     */
    boolean touching(int a, int b) {
        Pairs pairs = state.pairs();
        int ofA = bodies.firstPairOf(a);
        int ofB = bodies.firstPairOf(b);
        boolean isTouching = false;
        while (ofA != Pairs.NONE && ofB != Pairs.NONE && !isTouching) {
            isTouching =
                    pairs.other(ofA, a) == b && pairs.touching[ofA]
                            || pairs.other(ofB, b) == a && pairs.touching[ofB];
            ofA = pairs.nextOf(ofA, a);
            ofB = pairs.nextOf(ofB, b);
        }
        return isTouching;
    }

    Optional<RigidBody> bodyAt(double x, double y) {
        Require.finite("Pool.bodyAt x", x, "m");
        Require.finite("Pool.bodyAt y", y, "m");
        box.set(x, y, x, y);
        Found found = near(box);
        RigidBody last = null;
        for (int i = 0; i < found.count; i++) {
            int slot = found.numbers[i];
            int body = place(slot);
            if (!bodies.isSensor(slot) && pointAndRay.holds(bodies.outline[slot], pose, x, y)) {
                last = later(last, state.handle(body));
            }
        }
        return Optional.ofNullable(last);
    }

    /** Whether a filter meets a shape; it meets no sensor. */
    boolean meets(int slot, Filter filter) {
        if (bodies.isSensor(slot)) {
            return false;
        }
        Filter own = Filter.ALL.group(bodies.group[slot]);
        return filter.meets(
                bodies.category == null
                        ? own
                        : own.category(bodies.category[slot]).mask(bodies.mask[slot]));
    }

    /** Whether any part of a body contains a point. */
    boolean holds(int body, double x, double y) {
        pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
        boolean holds = false;
        for (int slot = body; slot != Pairs.NONE && !holds; slot = bodies.nextShapeOf(slot)) {
            holds = !bodies.isSensor(slot) && pointAndRay.holds(bodies.outline[slot], pose, x, y);
        }
        return holds;
    }

    /** Sets the pose to that of a shape's body and returns the body's slot. */
    private int place(int slot) {
        int body = bodies.bodyOf(slot);
        pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
        return body;
    }

    /** The body that was added later; slots are reused, so their order does not tell. */
    private RigidBody later(RigidBody one, RigidBody other) {
        return one == null || state.place(one) < state.place(other) ? other : one;
    }

    Optional<RayHit> rayCast(double fromX, double fromY, double toX, double toY, Filter filter) {
        PoolCasts.requireWay("rayCast", fromX, fromY, toX, toY);
        FixtureSearch search = state.search();
        if (search != null) {
            return ray.first(search, fromX, fromY, toX, toY, filter);
        }
        box.set(
                Math.min(fromX, toX),
                Math.min(fromY, toY),
                Math.max(fromX, toX),
                Math.max(fromY, toY));
        return ray.first(near(box), fromX, fromY, toX, toY, filter);
    }

    /** The ray cast, with the work counters of its last use. */
    RayCast ray() {
        return ray;
    }

    /** Bodies whose shape, not only whose fixture, overlaps the box. */
    Set<RigidBody> overlapping(Aabb area) {
        Set<RigidBody> inside = new LinkedHashSet<>();
        double width = area.maxX - area.minX;
        double height = area.maxY - area.minY;
        // A box without an area cannot be a polygon; half a nanometre does not matter to any body.
        Outline outline =
                Polygon.box(Math.max(width, LEAST_SIDE), Math.max(height, LEAST_SIDE)).outline();
        areaPose.set((area.minX + area.maxX) / 2, (area.minY + area.maxY) / 2, 1, 0);
        Found found = near(area);
        for (int i = 0; i < found.count; i++) {
            int slot = found.numbers[i];
            int body = place(slot);
            if (!bodies.isSensor(slot)
                    && touching.areTouching(outline, areaPose, bodies.outline[slot], pose)) {
                inside.add(state.handle(body));
            }
        }
        return inside;
    }

    /**
     * The slots of all shapes that may overlap a box. Without contacts there are no fixtures, so it
     * then compares the bounds of every shape.
     */
    Found near(Aabb area) {
        FixtureSearch search = state.search();
        if (search != null) {
            return search.query(area);
        }
        near.clear();
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.type[slot] != null && !bodies.isDisabled(bodies.bodyOf(slot))) {
                bounds(slot, bounds);
                if (bounds.overlaps(area)) {
                    near.add(slot);
                }
            }
        }
        return near;
    }

    private void bounds(int slot, Aabb into) {
        int body = bodies.bodyOf(slot);
        bodies.outline[slot].bounds(
                bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body], into);
    }

    /**
     * Writes the fixture of a body (for a compound, around all its parts), or its bounds if it has
     * no fixture.
     */
    void sizeFixture(int body, Aabb into) {
        fixture(body, into);
        for (int slot = bodies.nextShapeOf(body); slot != Pairs.NONE; ) {
            fixture(slot, bounds);
            into.enclose(bounds);
            slot = bodies.nextShapeOf(slot);
        }
    }

    private void fixture(int slot, Aabb into) {
        if (bodies.firstPair == null || bodies.isDisabled(bodies.bodyOf(slot))) {
            bounds(slot, into);
        } else {
            into.set(
                    bodies.fixtureMinX[slot],
                    bodies.fixtureMinY[slot],
                    bodies.fixtureMaxX[slot],
                    bodies.fixtureMaxY[slot]);
        }
    }
}
