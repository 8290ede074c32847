package rigibo.backend.collision;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.RoundOff;

/**
 * Removes contact points that cannot touch, because they lie inside the seam between two fixed
 * bodies. A floor made of boxes is one plane, yet each box has sides and corners of its own; a body
 * that slides over the floor would catch on a side that the neighbouring box covers.
 */
final class Seams {

    private final Bodies bodies;
    private final Pairs pairs;

    private final SeamPoint at;
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final SeamCover cover;
    private final PartSeams ofParts;

    /** Point of a face's plane nearest to the mover, world, m. */
    private double footX;

    private double footY;

    Seams(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        at = new SeamPoint(data);
        cover = new SeamCover(data, at);
        ofParts = new PartSeams(data, at, cover);
    }

    /**
     * Removes the covered points of a contact between a dynamic body and a fixed or driven one,
     * measured at the start of the step.
     */
    void leaveOutCovered(int pair) {
        if (mayBeCovered(pair)) {
            place(at.mover, at.moverPose);
            place(at.fixed, at.fixedPose);
            leaveOut(pair);
        }
        if (ofParts.mayHave(pair)) {
            place(pairs.bodyA[pair], poseA);
            place(pairs.bodyB[pair], poseB);
            ofParts.leaveOut(pair, poseA, poseB);
        }
    }

    /** Removes the covered points of a contact that was measured at these poses. */
    void leaveOutCovered(int pair, Pose atA, Pose atB) {
        leaveOutOfFixed(pair, atA, atB);
        if (ofParts.mayHave(pair)) {
            ofParts.leaveOut(pair, atA, atB);
        }
    }

    /** Removes the covered points of a contact measured again, at poses within the step. */
    void leaveOutCoveredAgain(int pair, Pose atA, Pose atB) {
        leaveOutOfFixed(pair, atA, atB);
        if (ofParts.mayHave(pair)) {
            ofParts.turnOrLeaveOut(pair, atA, atB);
        }
    }

    private void leaveOutOfFixed(int pair, Pose atA, Pose atB) {
        if (mayBeCovered(pair)) {
            boolean isMoverA = at.mover == pairs.bodyA[pair];
            at.moverPose.set(isMoverA ? atA : atB);
            at.fixedPose.set(isMoverA ? atB : atA);
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
        at.mover = isAMoving ? a : b;
        at.fixed = isAMoving ? b : a;
        at.moverShape = pairs.shapeOf(pair, at.mover);
        at.fixedShape = pairs.shapeOf(pair, at.fixed);
        return pairs.points[pair] > 0
                && isAMoving != bodies.isDynamic(b)
                && !bodies.outline[at.fixedShape].isDisc();
    }

    /**
     * Removes the covered points of a contact. A body that only flies past a neighbour may still
     * touch a place that the neighbour covers now, so its point is removed only if a face takes its
     * place.
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
     * Whether the mover may land at the point within the step: the point is before the plane of a
     * face that emerges from its neighbours farther along. A box with a corner on each of two
     * plates also reaches the second plate with the other corner; until then that plate's plane
     * lies behind the face on which the box slides.
     */
    private boolean isAwaited(int pair, int point) {
        return pairs.separation[point] > at.touching() && at.findFace() && cover.emerges(pair);
    }

    /** Whether the pair has no other point, or only one whose normal is not that of a face. */
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
     * Replaces a covered point by a face of the fixed body: the uncovered face that the mover is
     * farthest in front of. A body at the foot of a wall overlaps the wall's lower corner by less
     * than the wall, but that corner is inside the floor, and the body enters the wall's face. A
     * body that reaches the next piece of a rising floor meets its face within the step, though
     * only the covered corner is near yet.
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
            if (at.outX * coveredX + at.outY * coveredY > -RoundOff.OF_PLACES) {
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
     * Moves the point to the place where the mover is nearest to a face of the fixed body, or
     * deepest in it; returns the separation there, m. It is −∞ if the mover cannot reach the face:
     * a mover that is not over the face yet must be above its plane, since the face rises from the
     * covered corner.
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
        // A body deeper inside than its width came in through another face.
        double least = isOver ? -at.width : -at.touching();
        return separation > least ? separation : Double.NEGATIVE_INFINITY;
    }

    /**
     * Moves the point to the mover's lowest core corner above a face; returns the radius by which
     * the outline is lower, m.
     */
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
