package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Collider;
import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Outline;

/**
 * The distance of two shapes, its axis and the two closest points. It is computed from faces and
 * corners directly, not by iteration, so that it is exact to round-off. Uses scratch fields, so
 * each thread needs its own instance. Allocates nothing.
 */
public final class Distance {

    private final Collider collider = Collider.withoutBias();
    final Manifold manifold = new Manifold();

    /**
     * Gap found by the last call, m; in overlap, minus the shortest displacement that would part
     * the shapes.
     */
    public double gap;

    /** Unit vector from A to B along which the gap is largest. */
    public double axisX;

    public double axisY;

    /** The point of A nearest to B, in the world, m. */
    public double pointAX;

    public double pointAY;

    /** The point of B nearest to A, in the world, m. */
    public double pointBX;

    public double pointBY;

    /**
     * Sets the distance in m from the end of a chain's edge below which only the edge's own normal
     * counts, if the direction is one in which that end does not push.
     */
    void near(double metres) {
        collider.near = metres;
    }

    /** Measures two shapes at their poses and returns the gap in m. */
    public double measure(Outline a, Pose poseA, Outline b, Pose poseB) {
        collider.collide(a, poseA, b, poseB, Double.POSITIVE_INFINITY, manifold);
        int nearest =
                manifold.count == 2 && manifold.separation[1] < manifold.separation[0] ? 1 : 0;
        gap = manifold.separation[nearest];
        axisX = manifold.normalX;
        axisY = manifold.normalY;
        double halfX = axisX * gap / 2;
        double halfY = axisY * gap / 2;
        pointAX = manifold.pointX[nearest] - halfX;
        pointAY = manifold.pointY[nearest] - halfY;
        pointBX = manifold.pointX[nearest] + halfX;
        pointBY = manifold.pointY[nearest] + halfY;
        return gap;
    }
}
