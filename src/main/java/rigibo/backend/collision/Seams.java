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
 */
final class Seams {

    /**
     * Overlap in widths from which on any way out of a body of several parts is taken: what lies so
     * deep has not come over a seam.
     */
    private static final double DEEP = 0.05;

    private final Bodies bodies;
    private final Pairs pairs;

    private final SeamPoint at;
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final SeamCover cover;

    /** Where the mover is nearest to the plane of a face, world m. */
    private double footX;

    private double footY;

    Seams(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        at = new SeamPoint(data);
        cover = new SeamCover(data, at);
    }

    /**
     * Drops the covered points of a contact, between a body that moves and a fixed one, that was
     * measured where the step began.
     */
    void leaveOutCovered(int pair) {
        if (mayBeCovered(pair)) {
            place(at.mover, at.moverPose);
            place(at.fixed, at.fixedPose);
            leaveOut(pair);
        }
        if (mayBeInside(pair)) {
            place(pairs.bodyA[pair], poseA);
            place(pairs.bodyB[pair], poseB);
            leaveOutInside(pair, poseA, poseB);
        }
    }

    /** Drops the covered points of a contact that was measured at these poses of its bodies. */
    void leaveOutCovered(int pair, Pose atA, Pose atB) {
        if (mayBeCovered(pair)) {
            boolean isMoverA = at.mover == pairs.bodyA[pair];
            at.moverPose.set(isMoverA ? atA : atB);
            at.fixedPose.set(isMoverA ? atB : atA);
            leaveOut(pair);
        }
        if (mayBeInside(pair)) {
            leaveOutInside(pair, atA, atB);
        }
    }

    private boolean mayBeInside(int pair) {
        return bodies.mayHaveParts() && pairs.points[pair] > 0;
    }

    /**
     * Drops the points of a contact that lie inside a body that moves, where two of its parts meet:
     * what such a face or corner looks at is its other part. What is only near may come to another
     * place of the face within the step, and what is deep came in by it.
     */
    private void leaveOutInside(int pair, Pose atA, Pose atB) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        leaveOutInside(pair, a, atA, b, atB);
        leaveOutInside(pair, b, atB, a, atA);
    }

    private void leaveOutInside(int pair, int body, Pose pose, int other, Pose otherPose) {
        int shape = pairs.shapeOf(pair, body);
        boolean mayBeInside =
                pairs.points[pair] > 0
                        && bodies.isDynamic(body)
                        && (bodies.bodyOf(shape) != shape
                                || bodies.nextShapeOf(shape) != Pairs.NONE)
                        && !bodies.outline[shape].isDisc();
        if (!mayBeInside) {
            return;
        }
        at.isOfParts = true;
        at.mover = other;
        at.fixed = body;
        at.moverShape = pairs.shapeOf(pair, other);
        at.fixedShape = shape;
        at.moverPose.set(otherPose);
        at.fixedPose.set(pose);
        at.width = PairTolerances.width(bodies, body, other);
        cover.near = at.touching();
        for (int i = pairs.points[pair] - 1; i >= 0; i--) {
            at.look(pair, 2 * pair + i);
            double gap = pairs.separation[2 * pair + i];
            boolean isTouching = gap <= at.touching() && gap >= -DEEP * at.width;
            if (isTouching && cover.isCovered(pair)) {
                pairs.removePoint(pair, i);
            }
        }
        at.isOfParts = false;
    }

    private void place(int slot, Pose pose) {
        pose.set(bodies.x[slot], bodies.y[slot], bodies.cos[slot], bodies.sin[slot]);
    }

    private boolean mayBeCovered(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean isAMoving = bodies.isDynamic(a);
        at.mover = isAMoving ? a : b;
        at.fixed = isAMoving ? b : a;
        at.moverShape = pairs.shapeOf(pair, at.mover);
        at.fixedShape = pairs.shapeOf(pair, at.fixed);
        return pairs.points[pair] > 0
                && isAMoving != bodies.isDynamic(b)
                && !bodies.outline[at.fixedShape].isDisc();
    }

    /**
     * What only flies past a neighbour may still meet what the neighbour covers now: its point is
     * left out only where there is a face to take its place.
     */
    private void leaveOut(int pair) {
        at.width = bodies.smallestWidth[at.mover];
        for (int i = pairs.points[pair] - 1; i >= 0; i--) {
            int point = 2 * pair + i;
            at.look(pair, point);
            cover.near = Double.POSITIVE_INFINITY;
            if (cover.isCovered(pair)) {
                if (isAlone(pair, i) && turnsToFace(pair, point)) {
                    keepOnly(pair, i);
                    return;
                }
                at.look(pair, point);
                cover.near = at.touching();
                if (cover.isCovered(pair) && !isAwaited(pair, point)) {
                    pairs.removePoint(pair, i);
                }
            }
        }
    }

    /**
     * Whether the mover may land with the point within the step: it is before the plane of a face
     * that comes out of its neighbours farther on. A box that lies with a corner on each of two
     * plates comes to the second with the other one, too, and as long as it has not, the plane is
     * behind the face that it slides on.
     */
    private boolean isAwaited(int pair, int point) {
        return pairs.separation[point] > at.touching() && at.findFace() && cover.emerges(pair);
    }

    /** Whether the other point, if there is one, only looks along a normal that is none. */
    private boolean isAlone(int pair, int i) {
        return pairs.points[pair] == 1
                || pairs.separation[2 * pair + 1 - i] > at.touching() && !at.findFace();
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
        Outline polygon = bodies.outline[at.fixedShape];
        double coveredX = at.outX;
        double coveredY = at.outY;
        double best = Double.NEGATIVE_INFINITY;
        double bestX = 0;
        double bestY = 0;
        int faces = polygon.isEdge() ? 1 : polygon.corners();
        for (int i = 0; i < faces; i++) {
            at.outX = at.fixedPose.cos * polygon.normalX(i) - at.fixedPose.sin * polygon.normalY(i);
            at.outY = at.fixedPose.sin * polygon.normalX(i) + at.fixedPose.cos * polygon.normalY(i);
            if (at.outX * coveredX + at.outY * coveredY > -SeamPoint.ROUND_OFF) {
                double separation = placeOnFace(polygon, i);
                if (separation > best
                        && at.findFace()
                        && (!cover.isFaceCovered(pair) || cover.emerges(pair))) {
                    best = separation;
                    bestX = at.outX;
                    bestY = at.outY;
                    pairs.pointX[point] = footX + at.outX * separation / 2;
                    pairs.pointY[point] = footY + at.outY * separation / 2;
                }
            }
        }
        if (best == Double.NEGATIVE_INFINITY) {
            return false;
        }
        double sign = at.fixed == pairs.bodyA[pair] ? 1 : -1;
        pairs.reach[pair] = Double.NaN;
        pairs.normalX[pair] = sign * bestX;
        pairs.normalY[pair] = sign * bestY;
        pairs.faceOf[pair] = at.fixed;
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
        double startX = SeamPoint.worldX(at.fixedPose, polygon, face);
        double startY = SeamPoint.worldY(at.fixedPose, polygon, face);
        double endX = SeamPoint.worldX(at.fixedPose, polygon, next);
        double endY = SeamPoint.worldY(at.fixedPose, polygon, next);
        double below = placeLowest();
        double above = at.outX * (at.x - startX) + at.outY * (at.y - startY) - polygon.radius();
        footX = at.x - above * at.outX;
        footY = at.y - above * at.outY;
        double fromStart = at.outX * (footY - startY) - at.outY * (footX - startX);
        double toEnd = at.outX * (endY - footY) - at.outY * (endX - footX);
        boolean isBefore = fromStart < 0;
        boolean isBehind = toEnd < 0;
        at.x =
                isBefore
                        ? startX + at.outX * polygon.radius()
                        : isBehind ? endX + at.outX * polygon.radius() : footX;
        at.y =
                isBefore
                        ? startY + at.outY * polygon.radius()
                        : isBehind ? endY + at.outY * polygon.radius() : footY;
        boolean isOver = Math.min(fromStart, toEnd) > -SeamPoint.CLOSED * at.width;
        double separation = above - below;
        // What is deeper inside than it is wide came in by another face.
        double least = isOver ? -at.width : -at.touching();
        return separation > least ? separation : Double.NEGATIVE_INFINITY;
    }

    /** Moves the point to the mover's lowest above a face; returns how much lower it is yet, m. */
    private double placeLowest() {
        Outline shape = bodies.outline[at.moverShape];
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < shape.corners(); i++) {
            double cx = SeamPoint.worldX(at.moverPose, shape, i);
            double cy = SeamPoint.worldY(at.moverPose, shape, i);
            double height = at.outX * cx + at.outY * cy;
            if (height < least) {
                least = height;
                at.x = cx;
                at.y = cy;
            }
        }
        return shape.radius();
    }
}
