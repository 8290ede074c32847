package rigibo.backend.collision;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairIndex;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.RoundOff;

/**
 * Tests whether a point of a fixed body is covered by its neighbours, the other fixed bodies near
 * the mover.
 *
 * <p>A point on a face is covered where a neighbour fills the space in front of the face, at the
 * point and on both sides as far as the mover extends. If it fills only a strip of that space, the
 * mover stands in the corner of a floor and a wall and overlaps both a little. Beyond the mover's
 * extent the neighbour may leave the face, as below the kink between two plates that rise. A point
 * on a corner is covered where it lies on a neighbour that extends farther along the normal: then
 * the neighbour is nearer, and its own contact suffices.
 */
final class SeamCover {

    /**
     * Distance from the point at which the space before the face is tested, per metre of the mover.
     */
    private static final double ABOUT = 0.1;

    private final Bodies bodies;
    private final Pairs pairs;
    private final SeamPoint at;
    private final Pose pose = new Pose();

    /** Gap in m up to which a neighbour counts. */
    double near;

    SeamCover(DataStorage data, SeamPoint at) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.at = at;
    }

    /** Whether the point lies in the seam with a neighbour. */
    boolean isCovered(int pair) {
        if (first(pair) == Pairs.NONE) {
            return false;
        }
        return at.findFace() && at.comesToFace() ? isFaceCovered(pair) : isCornerCovered(pair);
    }

    /**
     * Whether a neighbour covers the face on both sides of the point, as far as the mover may reach
     * it, and at least next to the point.
     */
    boolean isFaceCovered(int pair) {
        double least = 2 * SeamPoint.CLOSED * at.width;
        double roomAhead = Math.min(at.ahead, Math.max(least, at.moverReaches(1)));
        double roomBehind = Math.min(at.behind, Math.max(least, at.moverReaches(-1)));
        for (int p = first(pair); p != Pairs.NONE; p = next(pair, p)) {
            if (coversFace(p, 1, roomAhead, roomBehind)
                    && coversFace(p, -1, roomBehind, roomAhead)) {
                return true;
            }
        }
        return false;
    }

    private boolean isCornerCovered(int pair) {
        for (int p = first(pair); p != Pairs.NONE; p = next(pair, p)) {
            if (coversCorner(p)) {
                return true;
            }
        }
        return false;
    }

    /** First pair of the mover with a neighbour. */
    private int first(int pair) {
        return at.isOfParts ? sibling(at.fixed) : neighbour(pair, bodies.firstPair[at.mover]);
    }

    private int next(int pair, int last) {
        return at.isOfParts
                ? sibling(bodies.nextShapeOf(pairs.shapeOf(last, at.fixed)))
                : neighbour(pair, pairs.nextOf(last, at.mover));
    }

    private int neighbour(int pair, int from) {
        int p = from;
        while (p != Pairs.NONE && !mayCover(pair, p)) {
            p = pairs.nextOf(p, at.mover);
        }
        return p;
    }

    private boolean mayCover(int pair, int other) {
        return other != pair
                && !bodies.isDynamic(pairs.other(other, at.mover))
                && !areOneChain(other)
                && pairs.gap(other) <= near;
    }

    /**
     * First pair, among the shapes of the fixed body from {@code from} on, between another of its
     * parts and the mover's shape. The pairs are searched by index, since in a crowd a body is in
     * ten times as many pairs as it has parts.
     */
    private int sibling(int from) {
        for (int s = from; s != Pairs.NONE; s = bodies.nextShapeOf(s)) {
            if (s != at.fixedShape) {
                int lower = Math.min(s, at.moverShape);
                int p = pairs.index.find(lower, Math.max(s, at.moverShape));
                if (p != PairIndex.ABSENT && isNear(p)) {
                    return p;
                }
            }
        }
        return Pairs.NONE;
    }

    /**
     * Whether the two shapes are near. A near pair may have no points, if they were left out as
     * inner ones.
     */
    private boolean isNear(int pair) {
        return pairs.gap(pair) <= near || pairs.points[pair] == 0 && pairs.touching[pair];
    }

    /** Whether both are edges of one chain, whose edges know their neighbours. */
    private boolean areOneChain(int other) {
        return bodies.outline[at.fixedShape].isEdge() && pairs.other(other, at.mover) == at.fixed;
    }

    /**
     * Whether the face, which neighbours cover at the point, emerges from them within the mover's
     * reach: overlapping boxes, like tiles, are a floor too.
     */
    boolean emerges(int pair) {
        return emerges(pair, 1, at.ahead) || emerges(pair, -1, at.behind);
    }

    /** Whether the face emerges on one side of the point, where it extends for {@code room} m. */
    private boolean emerges(int pair, int side, double room) {
        double gone = 0;
        for (int p = first(pair); p != Pairs.NONE; p = next(pair, p)) {
            gone = comesOut(p, side, gone, room);
        }
        return gone > 0
                && room - gone > SeamPoint.CLOSED * at.width
                && isVisible(pair, side * gone);
    }

    /**
     * Distance along the face from the point up to which a neighbour covers it, if it covers it at
     * {@code gone} m. Found by bisection, since a line meets a convex shape in one piece.
     */
    private double comesOut(int p, int side, double gone, double room) {
        if (!(depthAlong(p, side * gone) > SeamPoint.FLUSH * at.width)) {
            return gone;
        }
        if (depthAlong(p, side * room) > 0) {
            return room;
        }
        double inside = gone;
        double outside = room;
        while (outside - inside > SeamPoint.FLUSH * at.width) {
            double middle = (inside + outside) / 2;
            if (depthAlong(p, side * middle) > 0) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return outside;
    }

    private double depthAlong(int p, double along) {
        return depth(p, at.x - along * at.outY, at.y + along * at.outX);
    }

    /**
     * Whether no neighbour lies between the mover and a point of the face at a distance along it,
     * m.
     */
    private boolean isVisible(int pair, double along) {
        double px = at.x - along * at.outY;
        double py = at.y + along * at.outX;
        double toX = at.moverPose.x - px;
        double toY = at.moverPose.y - py;
        double step = SeamPoint.CLOSED * at.width / Math.sqrt(toX * toX + toY * toY);
        for (int p = first(pair); p != Pairs.NONE; p = next(pair, p)) {
            if (depth(p, px + step * toX, py + step * toY) > 0) {
                return false;
            }
        }
        return true;
    }

    /**
     * Whether a neighbour covers the space before the face on one side; {@code room} m of it lie on
     * that side, {@code other} m on the other.
     */
    private boolean coversFace(int p, int side, double room, double other) {
        if (room < SeamPoint.CLOSED * at.width && room < other) {
            return true;
        }
        double along = side * Math.min(ABOUT * at.width, room / 2);
        double before = SeamPoint.CLOSED * at.width;
        return depth(
                        p,
                        at.x + before * at.outX - along * at.outY,
                        at.y + before * at.outY + along * at.outX)
                > 0;
    }

    private boolean coversCorner(int p) {
        double flush = -SeamPoint.FLUSH * at.width;
        double before = SeamPoint.CLOSED * at.width;
        return depth(p, at.x + before * at.outX, at.y + before * at.outY) >= flush
                || depth(p, at.x, at.y) >= flush && reach(p) > RoundOff.OF_PLACES * at.width;
    }

    /**
     * Takes the pose of a neighbour: that of its columns for a fixed one, that of its body for
     * another part of the same body.
     */
    private void placeNeighbour(int p) {
        if (at.isOfParts) {
            pose.set(at.fixedPose);
        } else {
            int slot = pairs.other(p, at.mover);
            pose.set(bodies.x[slot], bodies.y[slot], bodies.cos[slot], bodies.sin[slot]);
        }
    }

    private Outline outlineOfNeighbour(int p) {
        int body = at.isOfParts ? at.fixed : pairs.other(p, at.mover);
        return bodies.outline[pairs.shapeOf(p, body)];
    }

    /** Depth of a world point in the neighbour of a pair, m; negative outside. */
    private double depth(int p, double px, double py) {
        placeNeighbour(p);
        double dx = px - pose.x;
        double dy = py - pose.y;
        Outline outline = outlineOfNeighbour(p);
        if (outline.isCentredDisc()) {
            return outline.radius() - Math.sqrt(dx * dx + dy * dy);
        }
        return outline.depth(pose.cos * dx + pose.sin * dy, pose.cos * dy - pose.sin * dx);
    }

    /** Distance along the normal by which the neighbour extends beyond the point, m. */
    private double reach(int p) {
        placeNeighbour(p);
        double centre = at.outX * (pose.x - at.x) + at.outY * (pose.y - at.y);
        Outline outline = outlineOfNeighbour(p);
        double localX = pose.cos * at.outX + pose.sin * at.outY;
        double localY = pose.cos * at.outY - pose.sin * at.outX;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.corners(); i++) {
            most = Math.max(most, localX * outline.cornerX(i) + localY * outline.cornerY(i));
        }
        return centre + (most + outline.radius());
    }
}
