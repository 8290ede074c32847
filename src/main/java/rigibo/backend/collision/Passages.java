package rigibo.backend.collision;

import rigibo.backend.collision.manifold.EdgeContact;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Decides for pairs with an edge of a chain or a one-way surface whether the bodies collide, or one
 * passes through the other. While they do not touch, their positions decide: they collide if the
 * other body is in the air of the edge, or wholly on the side of the one-way surface's normal. From
 * the moment they touch, the decision holds at any overlap, until they have parted. A body that is
 * passing one edge of a chain passes all edges of that chain, because its front is already beyond
 * the matter.
 */
final class Passages {

    private final Bodies bodies;
    private final Pairs pairs;
    private final EdgeContact edges = new EdgeContact();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    Passages(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Whether one of a pair's shapes is solid on one side only. */
    boolean isOneSided(int pair) {
        return pairs.passage != null
                && (isOneSidedShape(pairs.shapeA(pair)) || isOneSidedShape(pairs.shapeB(pair)));
    }

    private boolean isOneSidedShape(int slot) {
        return bodies.outline[slot].isEdge() || isOneWay(slot);
    }

    private boolean isOneWay(int slot) {
        return bodies.oneWayX[slot] != 0 || bodies.oneWayY[slot] != 0;
    }

    /** Decides for all active pairs, from the poses at the start of the step. */
    void decideActive() {
        boolean isAnyComing = false;
        for (int i = 0; i < pairs.activeCount; i++) {
            int pair = pairs.active[i];
            if (isOneSided(pair)) {
                place(pairs.bodyA[pair], poseA);
                place(pairs.bodyB[pair], poseB);
                decide(pair, poseA, poseB);
                isAnyComing |= pairs.passage[pair] == Pairs.COMES_THROUGH;
            }
        }
        for (int i = 0; isAnyComing && i < pairs.activeCount; i++) {
            int pair = pairs.active[i];
            if (isOneSided(pair) && comesThrough(pair)) {
                pairs.passage[pair] = Math.max(pairs.passage[pair], Pairs.PASSES);
            }
        }
    }

    private void place(int slot, Pose pose) {
        pose.set(bodies.x[slot], bodies.y[slot], bodies.cos[slot], bodies.sin[slot]);
    }

    /** Whether the last decision on a pair was to pass. */
    boolean isPassing(int pair) {
        return pairs.passage != null && pairs.passage[pair] >= Pairs.PASSES;
    }

    /** Decides at two poses whether the bodies of a one-sided pair pass through each other. */
    boolean isPassing(int pair, Pose atA, Pose atB) {
        decide(pair, atA, atB);
        return isPassing(pair) || comesThrough(pair);
    }

    /** Whether two bodies are passing through each other in another of their pairs. */
    private boolean comesThrough(int pair) {
        int a = pairs.bodyA[pair];
        int mover = bodies.isDynamic(a) ? a : pairs.bodyB[pair];
        int other = pairs.other(pair, mover);
        boolean comes = false;
        for (int p = bodies.firstPair[mover]; p != Pairs.NONE && !comes; ) {
            comes = pairs.passage[p] == Pairs.COMES_THROUGH && pairs.other(p, mover) == other;
            p = pairs.nextOf(p, mover);
        }
        return comes && !pairs.touched(pair);
    }

    private void decide(int pair, Pose atA, Pose atB) {
        int a = pairs.shapeA(pair);
        int b = pairs.shapeB(pair);
        int known = pairs.passage[pair];
        int byA = decide(a, atA, b, atB, pair, known);
        int byB = decide(b, atB, a, atA, pair, known);
        pairs.passage[pair] = Math.max(byA, byB);
    }

    private int decide(int slot, Pose at, int other, Pose otherAt, int pair, int known) {
        int byEdge = Pairs.MEETS;
        if (bodies.outline[slot].isEdge()) {
            byEdge = byEdge(bodies.outline[slot], at, bodies.outline[other], otherAt, known);
        }
        return isOneWay(slot)
                ? Math.max(byEdge, byNormal(slot, at, other, otherAt, pair, known))
                : byEdge;
    }

    private int byEdge(Outline edge, Pose at, Outline other, Pose otherAt, int known) {
        return switch (edges.side(edge, at, other, otherAt)) {
            case AIR -> Pairs.MEETS;
            case MATTER -> Pairs.PASSES;
            case ACROSS -> {
                boolean meets =
                        known == Pairs.UNDECIDED ? edges.isCentreInAir() : known == Pairs.MEETS;
                yield meets ? Pairs.MEETS : Pairs.COMES_THROUGH;
            }
        };
    }

    /** Decides by the one-way normal: all parts of the other body must lie on the normal's side. */
    private int byNormal(int slot, Pose at, int other, Pose otherAt, int pair, int known) {
        double localX = bodies.oneWayX[slot];
        double localY = bodies.oneWayY[slot];
        double nx = at.cos * localX - at.sin * localY;
        double ny = at.sin * localX + at.cos * localY;
        double top = highest(bodies.outline[slot], at, nx, ny, at);
        double low = Double.POSITIVE_INFINITY;
        for (int s = bodies.bodyOf(other); s != Pairs.NONE; s = bodies.nextShapeOf(s)) {
            low = Math.min(low, -highest(bodies.outline[s], otherAt, -nx, -ny, at));
        }
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        double overlap = known == Pairs.UNDECIDED ? PairTolerances.TOUCHING_GAP * width : 0;
        if (low - top >= -overlap) {
            return Pairs.MEETS;
        }
        return known == Pairs.MEETS && areTouching(pair) ? Pairs.MEETS : Pairs.PASSES;
    }

    /** Whether the bodies of a pair touch, or touched in the last step, with any of their parts. */
    private boolean areTouching(int pair) {
        int a = pairs.bodyA[pair];
        int mover = bodies.isDynamic(a) ? a : pairs.bodyB[pair];
        int other = pairs.other(pair, mover);
        boolean areTouching = pairs.touched(pair) || pairs.touchedBefore[pair];
        boolean areMany =
                bodies.nextShapeOf(mover) != Pairs.NONE || bodies.nextShapeOf(other) != Pairs.NONE;
        for (int p = bodies.firstPair[mover]; areMany && p != Pairs.NONE && !areTouching; ) {
            areTouching =
                    pairs.other(p, mover) == other
                            && pairs.passage[p] == Pairs.MEETS
                            && (pairs.touched(p) || pairs.touchedBefore[p]);
            p = pairs.nextOf(p, mover);
        }
        return areTouching;
    }

    /** Extent of an outline along a direction from the position of another one, m. */
    private static double highest(Outline outline, Pose at, double nx, double ny, Pose from) {
        double localX = at.cos * nx + at.sin * ny;
        double localY = at.cos * ny - at.sin * nx;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.corners(); i++) {
            most = Math.max(most, localX * outline.cornerX(i) + localY * outline.cornerY(i));
        }
        return nx * (at.x - from.x) + ny * (at.y - from.y) + (most + outline.radius());
    }
}
