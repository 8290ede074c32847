package rigibo.backend.collision;

import rigibo.backend.collision.manifold.Collider;
import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairOrder;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;
import rigibo.backend.storage.StillContacts;
import rigibo.backend.team.Team;

/**
 * The narrow phase: fills the manifolds of all candidate pairs with a moving body. A pair gets
 * points only if the two could touch within the step. The forces of the last step pass to the new
 * points with the same features, for warm starting.
 */
public final class Narrowphase {

    /** Smallest displacement that can be seen, per metre of body. */
    private static final double SHOWS = 0.02;

    /**
     * Number of active pairs from which on workers share them; also the size of a worker's piece.
     */
    private static final int WORTHWHILE = 512;

    private static final int GRAIN = 128;

    private final Bodies bodies;
    private final Pairs pairs;
    private final PairOrder order;
    private final Roster roster;
    private final Counters counters;
    private final StillContacts still;
    private final Collider collider = new Collider();
    private final Seams seams;
    private final WayOut wayOut;

    /** Null until the first body with several parts. */
    private InnerPoints inner;

    private OuterPoints outer;

    /** Null until the first shape that is solid on one side only. */
    private Passages passages;

    private final DataStorage data;
    private final Manifold manifold = new Manifold();
    private final FormerPoints former;
    private final Whereabouts whereabouts = new Whereabouts();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** Workers among which many pairs are shared; null for one worker. */
    private Team team;

    /** By worker: the narrow phase that measures its pairs; the first is this one. */
    private Narrowphase[] helpers = {this};

    private final Team.Pieces measuringPieces = this::measurePiece;

    /** Length of the step in progress, s. */
    private double dt;

    /** The narrow phase of a storage. */
    public Narrowphase(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        order = new PairOrder(data);
        roster = data.roster;
        counters = data.counters;
        still = data.stillContacts;
        seams = new Seams(data);
        wayOut = new WayOut(data, collider, manifold);
        former = new FormerPoints(data, manifold);
        this.data = data;
    }

    /** Shares pairs among a team of workers where there are many. */
    public void share(Team workers) {
        team = workers;
        helpers = new Narrowphase[workers.size()];
        helpers[0] = this;
        for (int i = 1; i < helpers.length; i++) {
            helpers[i] = new Narrowphase(data.forWorker());
        }
    }

    /** The narrow phase for a worker of the team; for worker 0 it is this one. */
    public Narrowphase of(int worker) {
        return helpers[worker];
    }

    /** Lists the active pairs and fills their manifolds for a step of {@code dt} seconds. */
    public void collide(double dt) {
        still.settle();
        pairs.beginStep();
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
                if (isListedBy(slot, pairs.other(p, slot))) {
                    pairs.activate(p);
                }
            }
        }
        order.restore();
        for (int i = 0; i < pairs.activeCount; i++) {
            begin(pairs.active[i]);
        }
        if (hasOneSided()) {
            passages.decideActive();
        }
        whereabouts.begin(bodies);
        measureActive(dt);
        for (int i = 0; i < pairs.activeCount; i++) {
            finish(pairs.active[i]);
        }
        if (bodies.mayHaveParts()) {
            if (inner == null) {
                outer = new OuterPoints(data);
                inner = new InnerPoints(data, outer);
            }
            inner.leaveOut(dt);
        }
    }

    /**
     * Leaves out the inner points of all piles at the end of a flight of {@code dt} s, which
     * measures contacts anew.
     */
    public void leaveOutInner(double dt) {
        if (inner != null) {
            inner.leaveOutOfPiles(dt);
        }
    }

    /**
     * Whether pairs lend each other points; such pairs may be measured again by one worker only.
     */
    public boolean isLending() {
        return outer != null;
    }

    /** Gives lent points back to their pairs, after piles have been solved. */
    public void giveOuterBack() {
        if (outer != null) {
            outer.settle();
        }
    }

    private void measureActive(double dt) {
        this.dt = dt;
        // All bodies are compared in any case, because the next step compares with the poses of
        // this one.
        for (int i = 0; i < pairs.activeCount; i++) {
            whereabouts.compare(bodies, pairs.bodyA[pairs.active[i]]);
            whereabouts.compare(bodies, pairs.bodyB[pairs.active[i]]);
        }
        if (team != null && pairs.activeCount >= WORTHWHILE) {
            team.split(pairs.activeCount, GRAIN, measuringPieces);
        } else {
            measurePiece(0, pairs.activeCount, 0);
        }
    }

    private void measurePiece(int from, int to, int worker) {
        for (int i = from; i < to; i++) {
            int pair = pairs.active[i];
            boolean hasStayed =
                    whereabouts.hasStayed(pairs.bodyA[pair])
                            && whereabouts.hasStayed(pairs.bodyB[pair]);
            double reach = reachIfHeld(pair, dt);
            if (hasStayed && isMeasured(pair, reach)) {
                goOn(pair);
            } else {
                helpers[worker].measure(pair, reach);
            }
        }
    }

    /**
     * Whether measuring the pair again would give its present points, since its bodies have not
     * moved.
     */
    private boolean isMeasured(int pair, double reach) {
        if (!(reach <= pairs.reach[pair])) {
            return false;
        }
        // A pair that is awaited is measured again, because that depends on the reach.
        return pairs.points[pair] == 0 ? !pairs.isAwaited(pair) : farthest(pair) <= reach;
    }

    private double farthest(int pair) {
        double first = pairs.separation[2 * pair];
        return pairs.points[pair] == 1 ? first : Math.max(first, pairs.separation[2 * pair + 1]);
    }

    /** Keeps the manifold: each point continues itself. */
    private void goOn(int pair) {
        for (int i = 0; i < 2; i++) {
            pairs.former[2 * pair + i] = i < pairs.points[pair] ? i : Pairs.NONE;
        }
    }

    private void begin(int pair) {
        pairs.touchedBefore[pair] = pairs.touched(pair);
        pairs.impacts[pair] = 0;
    }

    /**
     * Finishes a pair after its neighbours have been measured, since they decide whether a point
     * lies in a seam.
     */
    private void finish(int pair) {
        seams.leaveOutCovered(pair);
        noteTouch(pair);
    }

    private void measure(int pair, double reach) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        poseA.set(bodies.x[a], bodies.y[a], bodies.cos[a], bodies.sin[a]);
        poseB.set(bodies.x[b], bodies.y[b], bodies.cos[b], bodies.sin[b]);
        boolean isPassing = pairs.passage != null && pairs.passage[pair] >= Pairs.PASSES;
        fill(pair, isPassing, poseA, poseB, reach);
        pairs.reach[pair] = reach;
    }

    /** Fills a pair's manifold at poses of its bodies, with all points within a reach, m. */
    public void measure(int pair, Pose atA, Pose atB, double reach) {
        fill(pair, isPassing(pair, atA, atB), atA, atB, reach);
    }

    private void fill(int pair, boolean isPassing, Pose atA, Pose atB, double reach) {
        if (isPassing) {
            manifold.clear();
        } else {
            Outline outlineA = bodies.outline[pairs.shapeA(pair)];
            Outline outlineB = bodies.outline[pairs.shapeB(pair)];
            collider.collide(outlineA, atA, outlineB, atB, reach, manifold);
            if (outlineA.hasInner() || outlineB.hasInner()) {
                wayOut.take(pair, atA, atB, reach);
            }
        }
        double x = middle(pair, atA.x, atB.x);
        double y = middle(pair, atA.y, atB.y);
        keep(pair, x - pairs.middleX[pair], y - pairs.middleY[pair]);
        pairs.middleX[pair] = x;
        pairs.middleY[pair] = y;
        pairs.reach[pair] = Double.NaN;
    }

    /**
     * Whether the bodies of a pair pass through each other at these poses, because one of the
     * shapes is one-sided.
     */
    public boolean isPassing(int pair, Pose atA, Pose atB) {
        return isOneSided(pair) && passages.isPassing(pair, atA, atB);
    }

    /** Whether one of a pair's shapes is solid on one side only. */
    public boolean isOneSided(int pair) {
        return hasOneSided() && passages.isOneSided(pair);
    }

    private boolean hasOneSided() {
        if (pairs.passage != null && passages == null) {
            passages = new Passages(data);
        }
        return passages != null;
    }

    /**
     * Whether two bodies touch at these poses, within the gap that counts as touching; passages and
     * seams are not considered.
     */
    public boolean touches(int pair, Pose atA, Pose atB) {
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        collider.collide(
                bodies.outline[pairs.shapeA(pair)],
                atA,
                bodies.outline[pairs.shapeB(pair)],
                atB,
                PairTolerances.TOUCHING_GAP * width,
                manifold);
        return manifold.count > 0;
    }

    /**
     * Fills a pair's manifold like {@link #measure(int, Pose, Pose, double)}, and drops points that
     * lie in a seam, as the solver of piles needs it.
     */
    public void measureContact(int pair, Pose atA, Pose atB, double reach) {
        measure(pair, atA, atB, reach);
        seams.leaveOutCovered(pair, atA, atB);
    }

    /** Measures a contact of a pile again within the step, where its bodies are now. */
    public void measureAgain(int pair, Pose atA, Pose atB, double reach) {
        int lender = outer == null ? Pairs.NONE : outer.lenderOf(pair);
        if (lender == Pairs.NONE) {
            measureOneAgain(pair, atA, atB, reach);
            return;
        }
        int own = outer.giveBack(pair);
        measureOneAgain(pair, atA, atB, reach);
        measureOneAgain(lender, atA, atB, reach);
        outer.lendAgain(pair, own);
    }

    private void measureOneAgain(int pair, Pose atA, Pose atB, double reach) {
        measure(pair, atA, atB, reach);
        seams.leaveOutCoveredAgain(pair, atA, atB);
    }

    /**
     * Whether a pair is listed from this body's list. A pair of two moving bodies is found twice.
     * If both are dynamic, the lower slot lists it; the pair of a driven and a dynamic body is
     * listed by the dynamic one, like a pair with a fixed body. Contacts are solved in the order of
     * this list, and that order must not depend on whether the floor moves.
     */
    private boolean isListedBy(int slot, int other) {
        if (!bodies.isMoved(other)) {
            return true;
        }
        boolean isDynamic = bodies.isDynamic(slot);
        return isDynamic == bodies.isDynamic(other) ? slot < other : isDynamic;
    }

    /**
     * The gap in m that a pair could close in dt seconds if it is held on one side, by an upper
     * bound on its speeds.
     */
    public double reachIfHeld(int pair, double dt) {
        return reach(pair, dt) + wayIfHeld(pair, dt);
    }

    /** The gap in m that a pair could close in dt seconds, by an upper bound on its speeds. */
    public double reach(int pair, double dt) {
        return bodies.turns() ? turningReach(pair, dt) : reach(pair, dt, 0, 0);
    }

    private double turningReach(int pair, double dt) {
        return reach(pair, dt, turning(pairs.bodyA[pair], dt), turning(pairs.bodyB[pair], dt));
    }

    /**
     * The gap in m that a pair could close in dt seconds, when turning moves the outlines of A and
     * B at these speeds, m/s.
     */
    private double reach(int pair, double dt, double turningA, double turningB) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double vx = bodies.velocityX[b] - bodies.velocityX[a];
        double vy = bodies.velocityY[b] - bodies.velocityY[a];
        double ax = bodies.accelerationX[b] - bodies.accelerationX[a];
        double ay = bodies.accelerationY[b] - bodies.accelerationY[a];
        double speed = length(vx, vy) + turningA + turningB;
        double touching = PairTolerances.TOUCHING_GAP * PairTolerances.width(bodies, a, b);
        return touching + (speed + length(ax, ay) * dt) * dt;
    }

    /**
     * Distance in m by which a pair may approach beyond its reach. Forces that pull equally at both
     * bodies bring them together if one is held while the other slips, or tips about the corner on
     * which it lies. 0 if the distance would be too small to see.
     */
    private double wayIfHeld(int pair, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double pulled =
                length(bodies.accelerationX[a], bodies.accelerationY[a])
                        + length(bodies.accelerationX[b], bodies.accelerationY[b]);
        double way = pulled * dt * dt;
        return way > SHOWS * PairTolerances.width(bodies, a, b) ? way : 0;
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }

    /** Speed in m/s at which turning moves the outline; 0 for a disc. */
    private double turning(int slot, double dt) {
        double spin = Math.abs(bodies.spin[slot]) + Math.abs(bodies.angularAcceleration[slot]) * dt;
        return spin * bodies.sweepRadius[slot];
    }

    /** A coordinate of the pair's reference point, which moves along with both bodies. */
    private double middle(int pair, double ofA, double ofB) {
        if (!bodies.isDynamic(pairs.bodyA[pair])) {
            return ofA;
        }
        return bodies.isDynamic(pairs.bodyB[pair]) ? (ofA + ofB) / 2 : ofB;
    }

    /**
     * Stores the new manifold; the bodies have moved together by a displacement since the previous
     * one, m.
     */
    private void keep(int pair, double wayX, double wayY) {
        int first = 2 * pair;
        int from0 = manifold.count > 0 ? former.of(pair, 0, wayX, wayY) : Pairs.NONE;
        int from1 = manifold.count > 1 ? former.of(pair, 1, wayX, wayY) : Pairs.NONE;
        inherit(pairs.normalForce, first, from0, from1);
        inherit(pairs.load, first, from0, from1);
        pairs.former[first] = from0 == Pairs.NONE ? Pairs.NONE : from0 - first;
        pairs.former[first + 1] = from1 == Pairs.NONE ? Pairs.NONE : from1 - first;
        pairs.points[pair] = manifold.count;
        if (pairs.beside != null) {
            pairs.beside[pair] = manifold.beside;
        }
        if (manifold.count > 0 || pairs.isAwaited(pair)) {
            // Without points the manifold's normal belongs to another pair; a contact that ends
            // keeps its last normal.
            pairs.normalX[pair] = manifold.normalX;
            pairs.normalY[pair] = manifold.normalY;
            pairs.faceOf[pair] =
                    switch (manifold.source) {
                        case FACE_A -> pairs.bodyA[pair];
                        case FACE_B -> pairs.bodyB[pair];
                        case CLOSEST_POINTS -> Pairs.NONE;
                    };
        }
        for (int i = 0; i < manifold.count; i++) {
            pairs.pointX[first + i] = manifold.pointX[i];
            pairs.pointY[first + i] = manifold.pointY[i];
            pairs.separation[first + i] = manifold.separation[i];
            pairs.feature[first + i] = manifold.feature[i];
        }
    }

    private static void inherit(double[] column, int first, int from0, int from1) {
        double value0 = from0 == Pairs.NONE ? 0 : column[from0];
        double value1 = from1 == Pairs.NONE ? 0 : column[from1];
        column[first] = value0;
        column[first + 1] = value1;
    }

    private void noteTouch(int pair) {
        double gap = pairs.gap(pair);
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        pairs.touching[pair] = gap <= PairTolerances.TOUCHING_GAP * width;
        if (pairs.touching[pair]) {
            counters.contacts++;
            counters.deepestOverlap = Math.max(counters.deepestOverlap, -gap);
        }
    }
}
