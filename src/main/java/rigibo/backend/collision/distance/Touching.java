package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Collider;
import rigibo.backend.collision.manifold.EdgeContact;
import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;

/**
 * Tests whether outlines overlap or touch. An edge of a chain counts as a line with two sides;
 * {@link Collider} decides which contacts push. Uses scratch fields, so each thread needs its own
 * instance. Allocates nothing after its first edge of a chain.
 */
public final class Touching {

    private final Collider collider = new Collider();
    private final Manifold manifold = new Manifold();

    /** Null until the first edge of a chain. */
    private Distance distance;

    private EdgeContact edges;

    /** Whether two outlines have a point in common. */
    public boolean areTouching(Outline a, Pose poseA, Outline b, Pose poseB) {
        if (a.isEdge() || b.isEdge()) {
            return gapOfEdge(a, poseA, b, poseB) <= 0;
        }
        collider.collide(a, poseA, b, poseB, 0, manifold);
        return manifold.count > 0;
    }

    /**
     * Whether two outlines, one of them an edge, come within a share of the other one's width. A
     * reported impact fails this test if one only lay in the matter behind the edge.
     */
    public boolean areWithin(double share, Outline a, Pose poseA, Outline b, Pose poseB) {
        double width = Math.min(a.smallestWidth(), b.smallestWidth());
        return gapOfEdge(a, poseA, b, poseB) <= share * width;
    }

    private double gapOfEdge(Outline a, Pose poseA, Outline b, Pose poseB) {
        distance = distance == null ? new Distance() : distance;
        return distance.measure(a, poseA, b, poseB);
    }

    /** Whether one outline is an edge and the other lies wholly in the matter behind it. */
    public boolean isInMatter(Outline a, Pose poseA, Outline b, Pose poseB) {
        return a.isEdge() && isBehind(a, poseA, b, poseB)
                || b.isEdge() && isBehind(b, poseB, a, poseA);
    }

    private boolean isBehind(Outline edge, Pose poseE, Outline other, Pose poseO) {
        edges = edges == null ? new EdgeContact() : edges;
        return edges.side(edge, poseE, other, poseO) == EdgeContact.Side.MATTER;
    }
}
