package rigibo.backend.collision;

import rigibo.backend.geometry.Outline;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * A point on a fixed body at which another may touch it: who the two are, where they are, and the
 * face that the point is on.
 */
final class SeamPoint {

    /** Step in a floor that counts as none, per metre of what slides over it. */
    static final double FLUSH = 1e-5;

    /** Width of a seam that counts as closed, per metre of what slides over it. */
    static final double CLOSED = 2e-3;

    /** Round-off, per metre of what slides. */
    static final double ROUND_OFF = 1e-9;

    /** Sine of the angle up to which a normal is that of a face, where a face may lie on it. */
    private static final double PARALLEL = 1e-2;

    private final Bodies bodies;
    private final Pairs pairs;

    /** Whether the seam is between parts of one body, which is then called the fixed one. */
    boolean isOfParts;

    /** The body that moves, the fixed one, and the width in m of the first. */
    int mover;

    int fixed;
    double width;

    /** The slots of the shapes of both that the pair is of. */
    int moverShape;

    int fixedShape;

    /** Where the two are: neighbours that do not move are where their columns say. */
    final Pose moverPose = new Pose();

    final Pose fixedPose = new Pose();

    /** The point, world m, and the normal out of the fixed body. */
    double x;

    double y;
    double outX;
    double outY;

    /** How far the face that holds the point goes on along (−outY, outX), and against it, m. */
    double ahead;

    double behind;

    SeamPoint(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Goes to a point of the contact, on the fixed body, and looks along its normal. */
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

    /** Looks for the face that the normal belongs to, by the corners that lie as high. */
    boolean findFace() {
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
    boolean comesToFace() {
        double roomAhead = Math.min(ahead, moverReaches(1));
        return Math.max(roomAhead, Math.min(behind, moverReaches(-1))) > FLUSH * width;
    }

    /** How much farther along the face than the point the mover reaches, or against it, m. */
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

    /** Gap in m up to which the mover touches. */
    double touching() {
        return PairTolerances.TOUCHING_GAP * width;
    }
}
