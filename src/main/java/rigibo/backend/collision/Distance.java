package rigibo.backend.collision;

import rigibo.backend.geometry.Outline;

/**
 * The distance of two shapes, the axis along it, and the two points it is measured between. Found
 * from the faces and corners directly rather than by iteration, so that it is exact to round-off.
 * Holds scratch, so each thread needs its own. Allocates nothing.
 */
public final class Distance {

    private final Collider collider = Collider.withoutBias();
    final Manifold manifold = new Manifold();

    /** Gap found by the last call, m; in overlap minus the least way that would part the shapes. */
    public double gap;

    /** Unit vector from A to B along which no other gives a larger gap. */
    public double axisX;

    public double axisY;

    /** The point of A nearest to B, in the world, m. */
    public double pointAX;

    public double pointAY;

    /** The point of B nearest to A, in the world, m. */
    public double pointBX;

    public double pointBY;

    /**
     * How near in m something may come to the end of a chain's edge, in a direction in which that
     * does not push, before only the edge's own normal counts.
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
