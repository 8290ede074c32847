package rigibo.backend.collision;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

/**
 * Finds where two shapes touch or nearly touch. Holds scratch, so each thread needs its own.
 * Allocates nothing.
 */
public final class Collider {

    private final PolygonPolygon polygons;

    /** Manifolds for contacts, which keep their reference face while bodies rest on each other. */
    public Collider() {
        this(PolygonPolygon.REFERENCE_BIAS);
    }

    private Collider(double bias) {
        polygons = new PolygonPolygon(bias);
    }

    /** Manifolds whose least separation is the distance also where two faces are near parallel. */
    static Collider withoutBias() {
        return new Collider(0);
    }

    /**
     * Writes the manifold of two shapes. Where they are apart, the separation of one point is the
     * true distance; two points are given where faces are near parallel. Overlap is measured along
     * the axis of least overlap. Everything is computed relative to A, and every tolerance scales
     * with the shapes: far from the origin or in another scale, the manifold is the same.
     *
     * @param a first shape
     * @param poseA where it is
     * @param b second shape
     * @param poseB where it is
     * @param reach largest gap in m, zero or more, at which a point is still reported
     * @param out receives the manifold; its count is 0 when the shapes are farther apart than reach
     */
    public void collide(Shape a, Pose poseA, Shape b, Pose poseB, double reach, Manifold out) {
        out.clear();
        int points =
                switch (a.kind()) {
                    case CIRCLE -> collideCircle((Circle) a, poseA, b, poseB, reach, out);
                    case POLYGON -> collidePolygon((Polygon) a, poseA, b, poseB, reach, out);
                };
        assert points == out.count;
    }

    private static int collideCircle(
            Circle a, Pose poseA, Shape b, Pose poseB, double reach, Manifold out) {
        return switch (b.kind()) {
            case CIRCLE -> CircleCircle.collide(a, poseA, (Circle) b, poseB, reach, out);
            case POLYGON -> PolygonCircle.exchanged(a, poseA, (Polygon) b, poseB, reach, out);
        };
    }

    private int collidePolygon(
            Polygon a, Pose poseA, Shape b, Pose poseB, double reach, Manifold out) {
        return switch (b.kind()) {
            case CIRCLE -> PolygonCircle.collide(a, poseA, (Circle) b, poseB, reach, out);
            case POLYGON -> polygons.collide(a, poseA, (Polygon) b, poseB, reach, out);
        };
    }
}
