package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;

/**
 * Computes the contact manifold of two outlines at their poses. Uses scratch fields, so each thread
 * needs its own instance. Allocates nothing after its first edge of a chain.
 */
public final class Collider {

    private final PolygonPolygon polygons;
    private final boolean isForDistance;

    /** Null until the first edge of a chain. */
    private EdgeContact edges;

    /**
     * For distances: distance in m from the end of a chain's edge below which the edge's own normal
     * counts, if the direction is one in which that end does not push.
     */
    public double near;

    /**
     * A collider for contacts: manifolds keep their reference face while bodies rest on each other.
     */
    public Collider() {
        this(PolygonPolygon.REFERENCE_BIAS);
    }

    private Collider(double bias) {
        polygons = new PolygonPolygon(bias);
        isForDistance = bias == 0;
    }

    /**
     * A collider for distances: the least separation is the distance even where two faces are
     * nearly parallel.
     */
    public static Collider withoutBias() {
        return new Collider(0);
    }

    /**
     * Writes the manifold of two outlines. If they are apart, the separation of one point is the
     * true distance; a second point is given where faces are nearly parallel. Overlap is measured
     * along the axis of least overlap. All arithmetic is relative to A, and every tolerance scales
     * with the shapes, so that the manifold is the same far from the origin or at another scale.
     *
     * @param a first outline
     * @param poseA its pose
     * @param b second outline
     * @param poseB its pose
     * @param reach largest gap in m, zero or more, at which a point is still reported
     * @param out receives the manifold; its count is 0 when the gap is larger than reach
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

    /**
     * Replaces the manifold of two polygons that overlap deeply, one of which has faces that other
     * parts of its body cover, by one that leads out of both bodies. Must be called after {@link
     * #collide} with the same arguments.
     */
    public void leave(Outline a, Pose poseA, Outline b, Pose poseB, double reach, Manifold out) {
        boolean arePolygons = !a.isDisc() && !b.isDisc() && !a.isEdge() && !b.isEdge();
        if (arePolygons) {
            polygons.leave(a, poseA, b, poseB, reach, out);
        }
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
