package rigibo.backend.collision;

import rigibo.backend.geometry.Outline;

/**
 * Finds where two outlines touch or nearly touch. Holds scratch, so each thread needs its own.
 * Allocates nothing.
 */
public final class Collider {

    private final PolygonPolygon polygons;
    private final boolean isForDistance;

    /** Made with the first edge of a chain. */
    private EdgeContact edges;

    /**
     * Of a distance: how near in m something comes to the end of a chain's edge, in a direction in
     * which that does not push, before the edge's own normal counts.
     */
    double near;

    /** Manifolds for contacts, which keep their reference face while bodies rest on each other. */
    public Collider() {
        this(PolygonPolygon.REFERENCE_BIAS);
    }

    private Collider(double bias) {
        polygons = new PolygonPolygon(bias);
        isForDistance = bias == 0;
    }

    /** Manifolds whose least separation is the distance also where two faces are near parallel. */
    static Collider withoutBias() {
        return new Collider(0);
    }

    /**
     * Writes the manifold of two outlines. Where they are apart, the separation of one point is the
     * true distance; two points are given where faces are near parallel. Overlap is measured along
     * the axis of least overlap. Everything is computed relative to A, and every tolerance scales
     * with the shapes: far from the origin or in another scale, the manifold is the same.
     *
     * @param a first outline
     * @param poseA where it is
     * @param b second outline
     * @param poseB where it is
     * @param reach largest gap in m, zero or more, at which a point is still reported
     * @param out receives the manifold; its count is 0 when the shapes are farther apart than reach
     */
    public void collide(Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        out.clear();
        if (a.isEdge()) {
            collideEdge(a, poseA, b, poseB, reach, out);
            return;
        }
        if (b.isEdge()) {
            collideEdge(b, poseB, a, poseA, reach, out);
            out.exchange();
            return;
        }
        int points =
                a.isDisc()
                        ? collideDisc(a, poseA, b, poseB, reach, out)
                        : collidePolygon(a, poseA, b, poseB, reach, out);
        assert points == out.count;
    }

    private void collideEdge(
            Outline edge, Pose poseE, Outline other, Pose poseO, double reach, Manifold out) {
        edges = edges == null ? new EdgeContact() : edges;
        if (isForDistance) {
            edges.distance(edge, poseE, other, poseO, near, out);
        } else {
            edges.collide(edge, poseE, other, poseO, reach, out);
        }
    }

    private static int collideDisc(
            Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        return b.isDisc()
                ? CircleCircle.collide(a, poseA, b, poseB, reach, out)
                : PolygonCircle.exchanged(a, poseA, b, poseB, reach, out);
    }

    private int collidePolygon(
            Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        return b.isDisc()
                ? PolygonCircle.collide(a, poseA, b, poseB, reach, out)
                : polygons.collide(a, poseA, b, poseB, reach, out);
    }
}
