package rigibo.backend.collision.manifold;

import rigibo.backend.storage.Pairs;

/**
 * The contact of two shapes that touch or nearly touch. Mutable, so that stages can reuse one
 * object.
 */
public final class Manifold {

    /** Unit normal in the world, from A to B; meaningless while {@link #count} is 0. */
    public double normalX;

    public double normalY;

    /** Number of points: 0, 1 or 2. */
    public int count;

    /** World coordinates of each point, midway between the two surfaces, m. */
    public final double[] pointX = new double[2];

    public final double[] pointY = new double[2];

    /** Gap at each point along the normal, m; negative in overlap. */
    public final double[] separation = new double[2];

    /**
     * Feature id of each point. It is equal in two calls if the point is the same corner against
     * the same face, whichever polygon has the reference face.
     */
    public final int[] feature = new int[2];

    /**
     * Gap in m to an edge of a chain that has no point yet but may get one within the searched
     * reach; {@link #normalX} is then that of the edge. Negative in all other cases.
     */
    public double beside = Pairs.NOT_AWAITED;

    /** The feature that gave the normal. */
    public NormalSource source = NormalSource.CLOSEST_POINTS;

    /** Removes all points. */
    public void clear() {
        count = 0;
        beside = Pairs.NOT_AWAITED;
    }

    /** The smallest separation of the points, of which there is at least one, m. */
    public double deepest() {
        return count == 1 ? separation[0] : Math.min(separation[0], separation[1]);
    }

    /** Sets the normal. */
    void normal(double x, double y, NormalSource from) {
        normalX = x;
        normalY = y;
        source = from;
    }

    /** Rotates the normal from a shape's frame into the world's. */
    void turn(Pose pose) {
        double x = normalX;
        normalX = pose.cos * x - pose.sin * normalY;
        normalY = pose.sin * x + pose.cos * normalY;
    }

    /** Exchanges A and B. */
    void exchange() {
        normalX = -normalX;
        normalY = -normalY;
        source =
                switch (source) {
                    case FACE_A -> NormalSource.FACE_B;
                    case FACE_B -> NormalSource.FACE_A;
                    case CLOSEST_POINTS -> NormalSource.CLOSEST_POINTS;
                };
    }

    /** Converts the manifold of two cores into that of outlines with these radii, m. */
    void round(double radiusA, double radiusB) {
        double towardsB = (radiusA - radiusB) / 2;
        for (int i = 0; i < count; i++) {
            pointX[i] += towardsB * normalX;
            pointY[i] += towardsB * normalY;
            separation[i] -= radiusA + radiusB;
        }
    }

    /** Appends a point: world position in m, gap in m and feature id. */
    void add(double x, double y, double gap, int name) {
        pointX[count] = x;
        pointY[count] = y;
        separation[count] = gap;
        feature[count] = name;
        count++;
    }
}
