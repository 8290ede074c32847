package rigibo.backend.collision;

import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Leaves out what a body cannot touch since it lies inside the seam between two fixed bodies. A
 * floor of boxes is one plane, yet each box by itself has sides and corners: whatever slides over
 * it would bump into the side that the box before it covers.
 *
 * <p>A point on a face is covered where the space before the face is the neighbour's, at the point
 * and on all sides on which the mover reaches farther: where only a strip of it is, a body stands
 * in the corner of a floor and a wall, a little inside both. Where the mover does not come to, the
 * neighbour may leave the face, as below the kink between two plates that rise. A point on a corner
 * is covered where it lies on a neighbour that reaches farther along the normal: then the neighbour
 * is the nearer one, and the contact with it says all.
 */
final class Seams {

    /** Step in a floor that counts as none, per metre of what slides over it. */
    private static final double FLUSH = 1e-5;

    /** Width of a seam that counts as closed, per metre of what slides over it. */
    private static final double CLOSED = 2e-3;

    /** How far about a point a face is looked at, per metre of what slides over it. */
    private static final double ABOUT = 0.1;

    /** Round-off, per metre of what slides. */
    private static final double ROUND_OFF = 1e-9;

    /** Sine of the angle up to which a normal is that of a face, where a face may lie on it. */
    private static final double PARALLEL = 1e-2;

    private final Bodies bodies;
    private final Pairs pairs;

    /** The body that moves, the fixed one, and the width in m of the first. */
    private int mover;

    private int fixed;
    private double width;

    /** Gap in m up to which a neighbour counts. */
    private double near;

    /** The slots of the shapes of both that the pair is of. */
    private int moverShape;

    private int fixedShape;

    /** Where the two are: neighbours that do not move are where their columns say. */
    private final Pose moverPose = new Pose();

    private final Pose fixedPose = new Pose();

    /** A point on the fixed body, world m, and the normal out of it. */
    private double x;

    private double y;
    private double outX;
    private double outY;

    /** Where the mover is nearest to the plane of a face, world m. */
    private double footX;

    private double footY;

    /** How far the face that holds the point goes on along (−outY, outX), and against it, m. */
    private double ahead;

    private double behind;

    Seams(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /**
     * Drops the covered points of a contact, between a body that moves and a fixed one, that was
     * measured where the step began.
     */
    void leaveOutCovered(int pair) {
        if (mayBeCovered(pair)) {
            place(mover, moverPose);
            place(fixed, fixedPose);
            leaveOut(pair);
        }
    }

    /** Drops the covered points of a contact that was measured at these poses of its bodies. */
    void leaveOutCovered(int pair, Pose atA, Pose atB) {
        if (mayBeCovered(pair)) {
            boolean isMoverA = mover == pairs.bodyA[pair];
            moverPose.set(isMoverA ? atA : atB);
            fixedPose.set(isMoverA ? atB : atA);
            leaveOut(pair);
        }
    }

    private void place(int slot, Pose pose) {
        pose.set(bodies.x[slot], bodies.y[slot], bodies.cos[slot], bodies.sin[slot]);
    }

    private boolean mayBeCovered(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean isAMoving = bodies.isDynamic(a);
        mover = isAMoving ? a : b;
        fixed = isAMoving ? b : a;
        moverShape = pairs.shapeOf(pair, mover);
        fixedShape = pairs.shapeOf(pair, fixed);
        return pairs.points[pair] > 0
                && isAMoving != bodies.isDynamic(b)
                && !bodies.outline[fixedShape].isDisc();
    }

    /**
     * What only flies past a neighbour may still meet what the neighbour covers now: its point is
     * left out only where there is a face to take its place.
     */
    private void leaveOut(int pair) {
        width = bodies.smallestWidth[mover];
        for (int i = pairs.points[pair] - 1; i >= 0; i--) {
            int point = 2 * pair + i;
            look(pair, point);
            near = Double.POSITIVE_INFINITY;
            if (isCovered(pair)) {
                if (isAlone(pair, i) && turnsToFace(pair, point)) {
                    keepOnly(pair, i);
                    return;
                }
                look(pair, point);
                near = touching();
                if (isCovered(pair)) {
                    pairs.removePoint(pair, i);
                }
            }
        }
    }

    /** Goes to a point of the contact, on the fixed body, and looks along its normal. */
    private void look(int pair, int point) {
        int side = fixed == pairs.bodyA[pair] ? 1 : -1;
        outX = side * pairs.normalX[pair];
        outY = side * pairs.normalY[pair];
        x = pairs.pointX[point] - outX * pairs.separation[point] / 2;
        y = pairs.pointY[point] - outY * pairs.separation[point] / 2;
    }

    /** Whether the other point, if there is one, only looks along a normal that is none. */
    private boolean isAlone(int pair, int i) {
        return pairs.points[pair] == 1
                || pairs.separation[2 * pair + 1 - i] > touching() && !findFace();
    }

    private void keepOnly(int pair, int i) {
        if (pairs.points[pair] == 2) {
            pairs.removePoint(pair, 1 - i);
        }
    }

    /**
     * Puts a face of the fixed body in place of what is covered of it: the uncovered one that the
     * mover is farthest in front of. What lies at the foot of a wall overlaps the corner that the
     * wall has there by less than it does the wall; but the corner is inside the floor, and it is
     * the wall's face that it goes into. And what comes to the next piece of a floor that rises
     * meets its face within the step, though all that is near is its covered corner yet.
     */
    private boolean turnsToFace(int pair, int point) {
        Outline polygon = bodies.outline[fixedShape];
        double coveredX = outX;
        double coveredY = outY;
        double best = Double.NEGATIVE_INFINITY;
        double bestX = 0;
        double bestY = 0;
        int faces = polygon.isEdge() ? 1 : polygon.corners();
        for (int i = 0; i < faces; i++) {
            outX = fixedPose.cos * polygon.normalX(i) - fixedPose.sin * polygon.normalY(i);
            outY = fixedPose.sin * polygon.normalX(i) + fixedPose.cos * polygon.normalY(i);
            if (outX * coveredX + outY * coveredY > -ROUND_OFF) {
                double separation = placeOnFace(polygon, i);
                if (separation > best && findFace() && (!isFaceCovered(pair) || emerges(pair))) {
                    best = separation;
                    bestX = outX;
                    bestY = outY;
                    pairs.pointX[point] = footX + outX * separation / 2;
                    pairs.pointY[point] = footY + outY * separation / 2;
                }
            }
        }
        if (best == Double.NEGATIVE_INFINITY) {
            return false;
        }
        double sign = fixed == pairs.bodyA[pair] ? 1 : -1;
        pairs.reach[pair] = Double.NaN;
        pairs.normalX[pair] = sign * bestX;
        pairs.normalY[pair] = sign * bestY;
        pairs.faceOf[pair] = fixed;
        pairs.separation[point] = best;
        return true;
    }

    /**
     * Moves the point to where the mover is nearest to a face of the fixed body, or goes deepest
     * into it; returns how far it is from there, m. What has not come to the face yet is above its
     * plane, for a corner that is covered is one that the face rises from; −∞ where it is not.
     */
    private double placeOnFace(Outline polygon, int face) {
        int next = face + 1 == polygon.corners() ? 0 : face + 1;
        double startX = worldX(fixedPose, polygon, face);
        double startY = worldY(fixedPose, polygon, face);
        double endX = worldX(fixedPose, polygon, next);
        double endY = worldY(fixedPose, polygon, next);
        double below = placeLowest();
        double above = outX * (x - startX) + outY * (y - startY) - polygon.radius();
        footX = x - above * outX;
        footY = y - above * outY;
        double fromStart = outX * (footY - startY) - outY * (footX - startX);
        double toEnd = outX * (endY - footY) - outY * (endX - footX);
        boolean isBefore = fromStart < 0;
        boolean isBehind = toEnd < 0;
        x =
                isBefore
                        ? startX + outX * polygon.radius()
                        : isBehind ? endX + outX * polygon.radius() : footX;
        y =
                isBefore
                        ? startY + outY * polygon.radius()
                        : isBehind ? endY + outY * polygon.radius() : footY;
        boolean isOver = Math.min(fromStart, toEnd) > -CLOSED * width;
        double separation = above - below;
        // What is deeper inside than it is wide came in by another face.
        double least = isOver ? -width : -touching();
        return separation > least ? separation : Double.NEGATIVE_INFINITY;
    }

    /** Moves the point to the mover's lowest above a face; returns how much lower it is yet, m. */
    private double placeLowest() {
        Outline shape = bodies.outline[moverShape];
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < shape.corners(); i++) {
            double cx = worldX(moverPose, shape, i);
            double cy = worldY(moverPose, shape, i);
            double height = outX * cx + outY * cy;
            if (height < least) {
                least = height;
                x = cx;
                y = cy;
            }
        }
        return shape.radius();
    }

    private static double worldX(Pose pose, Outline polygon, int corner) {
        return pose.x + pose.cos * polygon.cornerX(corner) - pose.sin * polygon.cornerY(corner);
    }

    private static double worldY(Pose pose, Outline polygon, int corner) {
        return pose.y + pose.sin * polygon.cornerX(corner) + pose.cos * polygon.cornerY(corner);
    }

    private boolean isCovered(int pair) {
        return findFace() && comesToFace() ? isFaceCovered(pair) : isCornerCovered(pair);
    }

    private boolean isFaceCovered(int pair) {
        for (int p = bodies.firstPair[mover]; p != Pairs.NONE; p = pairs.nextOf(p, mover)) {
            int slot = pairs.other(p, mover);
            if (mayCover(pair, p, slot) && coversFace(slot, pairs.shapeOf(p, slot))) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether the face, which is inside neighbours at the point, comes out of them where the mover
     * may get at it: boxes that are laid like tiles make a floor too.
     */
    private boolean emerges(int pair) {
        return emerges(pair, 1, ahead) || emerges(pair, -1, behind);
    }

    /** The same to one side of the point, where the face goes on for so many metres. */
    private boolean emerges(int pair, int side, double room) {
        double gone = 0;
        for (int p = bodies.firstPair[mover]; p != Pairs.NONE; p = pairs.nextOf(p, mover)) {
            int slot = pairs.other(p, mover);
            if (mayCover(pair, p, slot)) {
                gone = comesOut(slot, pairs.shapeOf(p, slot), side, gone, room);
            }
        }
        return gone > 0 && room - gone > CLOSED * width && isVisible(pair, side * gone);
    }

    /**
     * How far along the face from the point a shape ends that covers it so far along, m: by
     * bisection, for what a line has in common with a convex shape is one piece.
     */
    private double comesOut(int slot, int shape, int side, double gone, double room) {
        if (!(depthAlong(slot, shape, side * gone) > FLUSH * width)) {
            return gone;
        }
        if (depthAlong(slot, shape, side * room) > 0) {
            return room;
        }
        double inside = gone;
        double outside = room;
        while (outside - inside > FLUSH * width) {
            double middle = (inside + outside) / 2;
            if (depthAlong(slot, shape, side * middle) > 0) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return outside;
    }

    private double depthAlong(int slot, int shape, double along) {
        return depth(slot, shape, x - along * outY, y + along * outX);
    }

    /** Whether no neighbour lies between the mover and a point so far along the face, m. */
    private boolean isVisible(int pair, double along) {
        double px = x - along * outY;
        double py = y + along * outX;
        double toX = moverPose.x - px;
        double toY = moverPose.y - py;
        double step = CLOSED * width / Math.sqrt(toX * toX + toY * toY);
        for (int p = bodies.firstPair[mover]; p != Pairs.NONE; p = pairs.nextOf(p, mover)) {
            int slot = pairs.other(p, mover);
            if (mayCover(pair, p, slot)
                    && depth(slot, pairs.shapeOf(p, slot), px + step * toX, py + step * toY) > 0) {
                return false;
            }
        }
        return true;
    }

    private boolean isCornerCovered(int pair) {
        for (int p = bodies.firstPair[mover]; p != Pairs.NONE; p = pairs.nextOf(p, mover)) {
            int slot = pairs.other(p, mover);
            if (mayCover(pair, p, slot) && coversCorner(slot, pairs.shapeOf(p, slot))) {
                return true;
            }
        }
        return false;
    }

    private boolean mayCover(int pair, int other, int slot) {
        return other != pair
                && !bodies.isDynamic(slot)
                && pairs.gap(other) <= near
                && !areOneChain(pair, other);
    }

    /** Edges of one chain know each other. */
    private boolean areOneChain(int pair, int other) {
        return bodies.outline[fixedShape].isEdge() && pairs.other(other, mover) == fixed;
    }

    private double touching() {
        return PairTolerances.TOUCHING_GAP * width;
    }

    /** Looks for the face that the normal belongs to, by the corners that lie as high. */
    private boolean findFace() {
        Outline polygon = bodies.outline[fixedShape];
        double parallel = isFaceOfMover() ? PARALLEL : ROUND_OFF;
        ahead = 0;
        behind = 0;
        for (int i = 0; i < polygon.corners(); i++) {
            double dx = worldX(fixedPose, polygon, i) - x;
            double dy = worldY(fixedPose, polygon, i) - y;
            double height = outX * dx + outY * dy + polygon.radius();
            double along = outX * dy - outY * dx;
            if (height >= -parallel * Math.abs(along)) {
                ahead = Math.max(ahead, along);
                behind = Math.max(behind, -along);
            }
        }
        return Math.max(ahead, behind) > FLUSH * width;
    }

    /** Whether the normal is that of one of the mover's faces, which may lie flat on the other. */
    private boolean isFaceOfMover() {
        Outline polygon = bodies.outline[moverShape];
        double localX = moverPose.cos * outX + moverPose.sin * outY;
        double localY = moverPose.cos * outY - moverPose.sin * outX;
        for (int i = 0; i < polygon.edges(); i++) {
            double nx = polygon.normalX(i);
            double ny = polygon.normalY(i);
            if (nx * localX + ny * localY < 0 && Math.abs(nx * localY - ny * localX) <= ROUND_OFF) {
                return true;
            }
        }
        return false;
    }

    /** Whether the mover may meet the face, and not only the corner at its end. */
    private boolean comesToFace() {
        double roomAhead = Math.min(ahead, moverReaches(1));
        return Math.max(roomAhead, Math.min(behind, moverReaches(-1))) > FLUSH * width;
    }

    /**
     * Whether it covers the face as far as the mover may come to it on both sides of the point, and
     * at least next to the point.
     */
    private boolean coversFace(int slot, int shape) {
        double least = 2 * CLOSED * width;
        double roomAhead = Math.min(ahead, Math.max(least, moverReaches(1)));
        double roomBehind = Math.min(behind, Math.max(least, moverReaches(-1)));
        return coversFace(slot, shape, 1, roomAhead, roomBehind)
                && coversFace(slot, shape, -1, roomBehind, roomAhead);
    }

    /** How much farther along the face than the point the mover reaches, or against it, m. */
    private double moverReaches(int side) {
        Outline outline = bodies.outline[moverShape];
        double most = 0;
        for (int i = 0; i < outline.corners(); i++) {
            double dx = worldX(moverPose, outline, i) - x;
            double dy = worldY(moverPose, outline, i) - y;
            most = Math.max(most, side * (outX * dy - outY * dx) + outline.radius());
        }
        return most;
    }

    /** Whether the space before the face is covered to one side, of so much room in m to both. */
    private boolean coversFace(int slot, int shape, int side, double room, double other) {
        if (room < CLOSED * width && room < other) {
            return true;
        }
        double along = side * Math.min(ABOUT * width, room / 2);
        double before = CLOSED * width;
        return depth(
                        slot,
                        shape,
                        x + before * outX - along * outY,
                        y + before * outY + along * outX)
                > 0;
    }

    private boolean coversCorner(int slot, int shape) {
        double flush = -FLUSH * width;
        double before = CLOSED * width;
        return depth(slot, shape, x + before * outX, y + before * outY) >= flush
                || depth(slot, shape, x, y) >= flush && reach(slot, shape) > ROUND_OFF * width;
    }

    /** How deep a world point lies in a shape of a body, m; negative outside. */
    private double depth(int slot, int shape, double px, double py) {
        double dx = px - bodies.x[slot];
        double dy = py - bodies.y[slot];
        Outline outline = bodies.outline[shape];
        if (outline.isCentredDisc()) {
            return outline.radius() - Math.sqrt(dx * dx + dy * dy);
        }
        return outline.depth(
                bodies.cos[slot] * dx + bodies.sin[slot] * dy,
                bodies.cos[slot] * dy - bodies.sin[slot] * dx);
    }

    /** How much farther than the point a shape of a body reaches along the normal, m. */
    private double reach(int slot, int shape) {
        double centre = outX * (bodies.x[slot] - x) + outY * (bodies.y[slot] - y);
        Outline outline = bodies.outline[shape];
        double localX = bodies.cos[slot] * outX + bodies.sin[slot] * outY;
        double localY = bodies.cos[slot] * outY - bodies.sin[slot] * outX;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.corners(); i++) {
            most = Math.max(most, localX * outline.cornerX(i) + localY * outline.cornerY(i));
        }
        return centre + (most + outline.radius());
    }
}
