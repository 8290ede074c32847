package rigibo.backend.collision;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.RoundOff;

/**
 * A point at which the mover may touch a fixed body: the two bodies, their poses, and the face on
 * which the point lies.
 */
final class SeamPoint {

    /** Largest step in a floor that counts as level, per metre of the mover. */
    static final double FLUSH = 1e-5;

    /** Largest width of a seam that counts as closed, per metre of the mover. */
    static final double CLOSED = 2e-3;

    /**
     * Sine of the angle up to which a normal counts as that of a face on which a face of the mover
     * may lie.
     */
    private static final double PARALLEL = 1e-2;

    private final Bodies bodies;
    private final Pairs pairs;

    /**
     * Whether the seam is between two parts of one body; that body then takes the role of the fixed
     * one.
     */
    boolean isOfParts;

    /** The body that moves (the mover), the fixed one, and the width of the mover in m. */
    int mover;

    int fixed;
    double width;

    /** Slots of the two shapes in the pair. */
    int moverShape;

    int fixedShape;

    /** Poses of the two; fixed neighbours are posed as their columns say. */
    final Pose moverPose = new Pose();

    final Pose fixedPose = new Pose();

    /** The point, world, m, and the normal out of the fixed body. */
    double x;

    double y;
    double outX;
    double outY;

    /**
     * Distance for which the face extends from the point along (−outY, outX), and in the opposite
     * direction, m.
     */
    double ahead;

    double behind;

    SeamPoint(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Sets the point to one of the contact's points, on the fixed body, with its normal. */
    void look(int pair, int point) {
        int side = fixed == pairs.bodyA[pair] ? 1 : -1;
        outX = side * pairs.normalX[pair];
        outY = side * pairs.normalY[pair];
        x = pairs.pointX[point] - outX * pairs.separation[point] / 2;
        y = pairs.pointY[point] - outY * pairs.separation[point] / 2;
    }

    static double worldX(Pose pose, Outline polygon, int corner) {
        return pose.x + pose.cos * polygon.cornerX(corner) - pose.sin * polygon.cornerY(corner);
    }

    static double worldY(Pose pose, Outline polygon, int corner) {
        return pose.y + pose.sin * polygon.cornerX(corner) + pose.cos * polygon.cornerY(corner);
    }

    /** Finds the face of the normal, by the corners at the height of the point. */
    boolean findFace() {
        Outline polygon = bodies.outline[fixedShape];
        double parallel = isFaceOfMover() ? PARALLEL : RoundOff.OF_PLACES;
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

    /**
     * Whether the normal is that of one of the mover's faces, which may lie flat on the fixed body.
     */
    private boolean isFaceOfMover() {
        Outline polygon = bodies.outline[moverShape];
        double localX = moverPose.cos * outX + moverPose.sin * outY;
        double localY = moverPose.cos * outY - moverPose.sin * outX;
        for (int i = 0; i < polygon.edges(); i++) {
            double nx = polygon.normalX(i);
            double ny = polygon.normalY(i);
            if (nx * localX + ny * localY < 0
                    && Math.abs(nx * localY - ny * localX) <= RoundOff.OF_PLACES) {
                return true;
            }
        }
        return false;
    }

    /** Whether the mover may touch the face, not only the corner at its end. */
    boolean comesToFace() {
        double roomAhead = Math.min(ahead, moverReaches(1));
        return Math.max(roomAhead, Math.min(behind, moverReaches(-1))) > FLUSH * width;
    }

    /**
     * Distance by which the mover extends beyond the point along the face (side 1), or in the
     * opposite direction (−1), m.
     */
    double moverReaches(int side) {
        Outline outline = bodies.outline[moverShape];
        double most = 0;
        for (int i = 0; i < outline.corners(); i++) {
            double dx = worldX(moverPose, outline, i) - x;
            double dy = worldY(moverPose, outline, i) - y;
            most = Math.max(most, side * (outX * dy - outY * dx) + outline.radius());
        }
        return most;
    }

    /** Gap in m up to which the mover counts as touching. */
    double touching() {
        return PairTolerances.TOUCHING_GAP * width;
    }
}
