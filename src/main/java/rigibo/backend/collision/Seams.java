package rigibo.backend.collision;

import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Removes contact points that cannot touch, because they lie inside the seam between two fixed
 * bodies. A floor made of boxes is one plane, yet each box has sides and corners of its own; a body
 * that slides over the floor would catch on a side that the neighbouring box covers.
 */
final class Seams {

    /**
     * Overlap, in widths, beyond which any way out of a body with several parts is accepted; so
     * deep a body did not come over a seam.
     */
    static final double DEEP = 0.05;

    /** Sine of the angle up to which two faces count as lying flat on each other. */
    private static final double FLAT = 1e-2;

    /** Round-off of the direction between two points that are closest, and of a surface's end. */
    private static final double ROUND_OFF = 1e-5;

    /** Cosine of the largest angle by which a normal is turned to a surface. */
    private static final double STEEPEST = 0.8;

    private final Bodies bodies;
    private final Pairs pairs;

    private final SeamPoint at;
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();
    private final SeamCover cover;

    /** Point of a face's plane nearest to the mover, world, m. */
    private double footX;

    private double footY;

    private boolean isWithinStep;

    Seams(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
        at = new SeamPoint(data);
        cover = new SeamCover(data, at);
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
        if (mayBeInside(pair)) {
            place(pairs.bodyA[pair], poseA);
            place(pairs.bodyB[pair], poseB);
            leaveOutInside(pair, poseA, poseB);
        }
    }

    /**
     * Removes the covered points of a contact that was measured at these poses; within the step if
     * its bodies have moved since they were in contact.
     */
    void leaveOutCovered(int pair, Pose atA, Pose atB, boolean isWithin) {
        isWithinStep = isWithin;
        leaveOutCoveredAt(pair, atA, atB);
        isWithinStep = false;
    }

    private void leaveOutCoveredAt(int pair, Pose atA, Pose atB) {
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
     * Removes contact points inside a dynamic body, where two of its parts meet: such a face or
     * corner looks at the other part. Only touching points are removed. One that is merely near may
     * reach another place of the face within the step, and a deep one came in through this face.
     */
    private void leaveOutInside(int pair, Pose atA, Pose atB) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        boolean isShallow = pairs.gap(pair) >= -DEEP * PairTolerances.width(bodies, a, b);
        if (isShallow
                && (leadsInside(pair, pairs.shapeA(pair), atA, pairs.shapeB(pair), 1)
                        || leadsInside(pair, pairs.shapeB(pair), atB, pairs.shapeA(pair), -1))) {
            pairs.removePoints(pair);
            return;
        }
        leaveOutInside(pair, a, atA, b, atB);
        leaveOutInside(pair, b, atB, a, atA);
    }

    /**
     * Whether a contact's normal leads from one part of a body into the next, where nothing can
     * ever touch; side is 1 if the part is A's and -1 if it is B's. What has just come past the end
     * of a part within the step is held by the surface that the next part continues.
     */
    private boolean leadsInside(int pair, int shape, Pose pose, int other, int side) {
        Outline outline = bodies.outline[shape];
        if (!outline.hasInner()) {
            return false;
        }
        double x = side * pairs.normalX[pair];
        double y = side * pairs.normalY[pair];
        boolean isOfFace = pairs.faceOf[pair] != Pairs.NONE;
        int leads =
                outline.leads(
                        pose.cos * x + pose.sin * y,
                        pose.cos * y - pose.sin * x,
                        isOfFace ? FLAT : ROUND_OFF);
        // A corner at a seam that lies on a face of the other body is there to be touched.
        if (leads < 0 || isOfFace) {
            return leads == Outline.INSIDE;
        }
        double outX = outline.outermostX(leads);
        double outY = outline.outermostY(leads);
        double toX = pose.cos * outX - pose.sin * outY;
        double toY = pose.sin * outX + pose.cos * outY;
        if (!isWithinStep || toX * x + toY * y < STEEPEST) {
            return true;
        }
        turn(pair, side, toX, toY, bodies.outline[other].radius());
        return false;
    }

    /** Turns the normal at a corner; what touches it there is round, with a radius in m. */
    private void turn(int pair, int side, double toX, double toY, double radius) {
        double x = side * pairs.normalX[pair];
        double y = side * pairs.normalY[pair];
        int point = 2 * pair;
        double cornerX = pairs.pointX[point] - x * pairs.separation[point] / 2;
        double cornerY = pairs.pointY[point] - y * pairs.separation[point] / 2;
        double centre = pairs.separation[point] + radius;
        double separation = centre * (x * toX + y * toY) - radius;
        pairs.pointX[point] = cornerX + centre * x - (radius + separation / 2) * toX;
        pairs.pointY[point] = cornerY + centre * y - (radius + separation / 2) * toY;
        pairs.separation[point] = separation;
        pairs.normalX[pair] = side * toX;
        pairs.normalY[pair] = side * toY;
        pairs.faceOf[pair] = side == 1 ? pairs.bodyA[pair] : pairs.bodyB[pair];
        pairs.reach[pair] = Double.NaN;
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
     * Removes the covered points of a contact. A body that only flies past a neighbour may still
     * touch what the neighbour covers now, so its point is removed only if a face takes its place.
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
     * than the wall, but that corner is inside the floor, and the wall's face is what the body
     * enters. A body that reaches the next piece of a rising floor meets its face within the step,
     * though only the covered corner is near yet.
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
     * Moves the point to where the mover is nearest to a face of the fixed body, or deepest in it;
     * returns the separation there, m. It is −∞ where the mover cannot reach the face: a mover that
     * has not come over it yet must be above its plane, since the face rises from the covered
     * corner.
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
