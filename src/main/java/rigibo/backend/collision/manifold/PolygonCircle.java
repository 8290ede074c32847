package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;

/**
 * Manifold of a polygon and a disc: one point. The disc's centre is transformed into the polygon's
 * frame; the closest feature is the face that it is farthest in front of, or a corner of that face.
 */
final class PolygonCircle {

    private static final int NONE = -1;

    private PolygonCircle() {}

    /** The manifold with the polygon as A. */
    static int collide(Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        double dx = poseB.worldX(b.cornerX(0), b.cornerY(0)) - poseA.x;
        double dy = poseB.worldY(b.cornerX(0), b.cornerY(0)) - poseA.y;
        double cx = poseA.cos * dx + poseA.sin * dy;
        double cy = poseA.cos * dy - poseA.sin * dx;
        int face = outermost(a, cx, cy, a.radius() + b.radius() + reach);
        if (face == NONE) {
            return 0;
        }
        double gap = measure(a, face, cx, cy, out) - a.radius() - b.radius();
        if (gap > reach) {
            return 0;
        }
        double inward = b.radius() + gap / 2;
        double x = cx - out.normalX * inward;
        double y = cy - out.normalY * inward;
        out.turn(poseA);
        out.add(
                poseA.x + poseA.cos * x - poseA.sin * y,
                poseA.y + poseA.sin * x + poseA.cos * y,
                gap,
                0);
        return out.count;
    }

    /** The manifold with the disc as A. */
    static int exchanged(Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        collide(b, poseB, a, poseA, reach, out);
        out.exchange();
        return out.count;
    }

    /**
     * The face that a point is farthest in front of, or {@link #NONE} if that is more than {@code
     * most} m.
     */
    private static int outermost(Outline polygon, double x, double y, double most) {
        int face = NONE;
        double farthest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            double front =
                    polygon.normalX(i) * (x - polygon.cornerX(i))
                            + polygon.normalY(i) * (y - polygon.cornerY(i));
            if (front > farthest) {
                if (front > most) {
                    return NONE;
                }
                farthest = front;
                face = i;
            }
        }
        return face;
    }

    /**
     * Signed distance in m of a point from the core, negative inside; writes the normal in the
     * polygon's frame. Beside the face a corner is closest. The position along the face is measured
     * from each end separately, so that a mirrored scene gives mirrored bits.
     */
    private static double measure(Outline polygon, int face, double x, double y, Manifold out) {
        double nx = polygon.normalX(face);
        double ny = polygon.normalY(face);
        int next = face + 1 == polygon.corners() ? 0 : face + 1;
        double startX = x - polygon.cornerX(face);
        double startY = y - polygon.cornerY(face);
        double endX = x - polygon.cornerX(next);
        double endY = y - polygon.cornerY(next);
        double front = nx * startX + ny * startY;
        out.normal(nx, ny, NormalSource.FACE_A);
        // Even a point on the line of a core of two corners may be beside the core.
        boolean isOutside = front > 0 || polygon.corners() == 2;
        if (isOutside && ny * startX - nx * startY > 0) {
            return fromCorner(startX, startY, out);
        }
        if (isOutside && nx * endY - ny * endX > 0) {
            return fromCorner(endX, endY, out);
        }
        return front;
    }

    private static double fromCorner(double dx, double dy, Manifold out) {
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance > 0) {
            out.normal(dx / distance, dy / distance, NormalSource.CLOSEST_POINTS);
        }
        return distance;
    }
}
