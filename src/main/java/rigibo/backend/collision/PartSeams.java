package rigibo.backend.collision;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Removes contact points inside the seams of a dynamic body, where two of its parts meet: such a
 * face or corner looks at the other part. A contact whose normal leads into a covered edge is
 * removed at any distance. Of other contacts only touching points are removed: a near point may
 * reach another place of the face within the step, and a deep one came in through this face.
 */
final class PartSeams {

    /**
     * Overlap, in widths, beyond which any way out of a body with several parts is accepted; a body
     * so deep did not come over a seam.
     */
    static final double DEEP = 0.05;

    /** Sine of the angle up to which two faces count as lying flat on each other. */
    private static final double FLAT = 1e-2;

    /**
     * Sine of that angle where the normal is the line between closest points, exact to round-off.
     */
    private static final double CLOSEST = 1e-5;

    /** Height above a surface, in widths, up to which a body slides on it. */
    private static final double LEVEL = 1e-3;

    /** Cosine of the largest angle by which a normal is turned towards that of a surface. */
    private static final double STEEPEST = 0.8;

    private final Bodies bodies;
    private final Pairs pairs;
    private final SeamPoint at;
    private final SeamCover cover;

    PartSeams(DataStorage data, SeamPoint at, SeamCover cover) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.at = at;
        this.cover = cover;
    }

    /** Whether a contact may have points in such a seam. */
    boolean mayHave(int pair) {
        return bodies.mayHaveParts() && pairs.points[pair] > 0;
    }

    /** Whether a normal out of a part at a pose leads into another part that lies on its face. */
    static boolean leadsInside(Outline part, Pose pose, double x, double y) {
        return part.hasInner() && leads(part, pose, x, y, FLAT) == Outline.INSIDE;
    }

    private static int leads(Outline part, Pose pose, double x, double y, double sine) {
        return part.leads(pose.cos * x + pose.sin * y, pose.cos * y - pose.sin * x, sine);
    }

    /** Removes the points of a contact that was measured at these poses. */
    void leaveOut(int pair, Pose poseA, Pose poseB) {
        leaveOut(pair, poseA, poseB, false);
    }

    /**
     * Removes the points of a contact measured again, at poses within the step. A round body that
     * has just passed the end of a part is held by the surface that the next part continues: the
     * contact's normal turns to that of the surface.
     */
    void turnOrLeaveOut(int pair, Pose poseA, Pose poseB) {
        leaveOut(pair, poseA, poseB, true);
    }

    private void leaveOut(int pair, Pose poseA, Pose poseB, boolean isWithinStep) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double width = PairTolerances.width(bodies, a, b);
        boolean isInside =
                pairs.gap(pair) >= -DEEP * width
                        && (leadsInside(pair, 1, poseA, width, isWithinStep)
                                || leadsInside(pair, -1, poseB, width, isWithinStep));
        if (isInside) {
            pairs.removePoints(pair);
        } else {
            leaveOutOf(pair, a, poseA, b, poseB);
            leaveOutOf(pair, b, poseB, a, poseA);
        }
    }

    /**
     * Whether a contact's normal leads from one part of a body into the next, where no other body
     * can touch; side is 1 if the part is A's and -1 if it is B's.
     */
    private boolean leadsInside(int pair, int side, Pose pose, double width, boolean isWithinStep) {
        int shape = side == 1 ? pairs.shapeA(pair) : pairs.shapeB(pair);
        Outline outline = bodies.outline[shape];
        if (!outline.hasInner()) {
            return false;
        }
        double x = side * pairs.normalX[pair];
        double y = side * pairs.normalY[pair];
        boolean isOfFace = pairs.faceOf[pair] != Pairs.NONE;
        int leads = leads(outline, pose, x, y, isOfFace ? FLAT : CLOSEST);
        // A corner at a seam can be touched if it lies on a face of the other body.
        if (leads < 0 || isOfFace) {
            return leads == Outline.INSIDE;
        }
        int other = side == 1 ? pairs.shapeB(pair) : pairs.shapeA(pair);
        double radius = bodies.outline[other].radius();
        double centre = pairs.separation[2 * pair] + radius;
        double outX = outline.outermostX(leads);
        double outY = outline.outermostY(leads);
        double toX = pose.cos * outX - pose.sin * outY;
        double toY = pose.sin * outX + pose.cos * outY;
        double above = x * toX + y * toY;
        if (centre * above - radius > LEVEL * width) {
            // The body may come down on the corner.
            return false;
        }
        boolean isHeld =
                outline.rises(leads)
                        ? centre * Math.abs(x * toY - y * toX) < DEEP * width
                        : isWithinStep && above >= STEEPEST;
        if (isHeld) {
            turn(pair, side, toX, toY, radius);
        }
        return !isHeld;
    }

    /** Turns the normal at a corner that touches a round outline with a radius in m. */
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

    private void leaveOutOf(int pair, int body, Pose pose, int other, Pose otherPose) {
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
}
