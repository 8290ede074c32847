package rigibo.backend;

import rigibo.backend.broadphase.FixtureSearch;
import rigibo.backend.broadphase.RayWalk;
import rigibo.backend.collision.distance.PointAndRay;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.setup.Filter;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.Pairs;

import java.util.Optional;

/** Finds the first body that a ray hits. */
final class RayCast {

    private static final int NOBODY = -1;

    private final Queried state;
    private final PoolQueries queries;
    private final Bodies bodies;
    private final Pose pose = new Pose();
    private final PointAndRay pointAndRay = new PointAndRay();

    /** Which shapes the ray can hit; null for all. */
    private Filter filter;

    private double fromX;
    private double fromY;
    private double toX;
    private double toY;

    /** The first body hit so far; below, the fraction of the ray and the outward normal there. */
    private int met;

    private double fraction;
    private double normalX;
    private double normalY;

    private int nodes;
    private int shapes;

    RayCast(Queried state, PoolQueries queries) {
        this.state = state;
        this.queries = queries;
        bodies = state.bodies();
    }

    /** Searches the fixtures. */
    Optional<RayHit> first(
            FixtureSearch search, double fromX, double fromY, double toX, double toY, Filter whom) {
        filter = whom;
        begin(fromX, fromY, toX, toY);
        RayWalk walk = search.walk(fromX, fromY, toX, toY);
        for (int slot = walk.next(1); slot != RayWalk.END; slot = walk.next(fraction)) {
            ask(slot);
        }
        nodes = walk.nodes();
        return hit();
    }

    /** Searches the given shapes. */
    Optional<RayHit> first(
            Found slots, double fromX, double fromY, double toX, double toY, Filter whom) {
        filter = whom;
        begin(fromX, fromY, toX, toY);
        for (int i = 0; i < slots.count; i++) {
            ask(slots.numbers[i]);
        }
        return hit();
    }

    /** Number of boxes of the tree that the last ray was tested against. */
    int nodes() {
        return nodes;
    }

    /** Number of shapes that the last ray was tested against. */
    int shapes() {
        return shapes;
    }

    private void begin(double fromX, double fromY, double toX, double toY) {
        this.fromX = fromX;
        this.fromY = fromY;
        this.toX = toX;
        this.toY = toY;
        met = NOBODY;
        fraction = 1;
        nodes = 0;
        shapes = 0;
    }

    private void ask(int slot) {
        shapes++;
        int body = bodies.bodyOf(slot);
        pose.set(bodies.x[body], bodies.y[body], bodies.cos[body], bodies.sin[body]);
        double at = pointAndRay.enters(bodies.outline[slot], pose, fromX, fromY, toX, toY);
        boolean isSooner = at < fraction || at == fraction && isFirstAdded(slot);
        boolean isMet = filter == null ? !bodies.isSensor(slot) : queries.meets(slot, filter);
        if (isSooner && isMet && !startsWithin(body)) {
            met = slot;
            fraction = at;
            normalX = pointAndRay.normalX;
            normalY = pointAndRay.normalY;
        }
    }

    /**
     * Always false for a body in one piece: the ray test itself leaves out a body in which the ray
     * starts.
     */
    private boolean startsWithin(int body) {
        return bodies.nextShapeOf(body) != Pairs.NONE && queries.holds(body, fromX, fromY);
    }

    /**
     * Whether a shape comes before the hit one: by the order in which bodies were added, then by
     * the order of parts. Slots are reused, so their order does not tell.
     */
    private boolean isFirstAdded(int slot) {
        if (met == NOBODY) {
            return true;
        }
        int place = state.place(state.handle(bodies.bodyOf(slot)));
        int placeOfMet = state.place(state.handle(bodies.bodyOf(met)));
        return place < placeOfMet
                || place == placeOfMet && bodies.partOf(slot) < bodies.partOf(met);
    }

    private Optional<RayHit> hit() {
        if (met == NOBODY) {
            return Optional.empty();
        }
        return Optional.of(
                new RayHit(
                        state.handle(bodies.bodyOf(met)),
                        bodies.partOf(met),
                        fromX + fraction * (toX - fromX),
                        fromY + fraction * (toY - fromY),
                        normalX,
                        normalY,
                        fraction));
    }
}
