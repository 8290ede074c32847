package rigibo.backend.collision;

import rigibo.backend.storage.Pairs;

/** Where two shapes touch or nearly touch. A plain carrier that stages reuse. */
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
     * Names the features each point stems from: equal between two calls when the point is the same
     * corner against the same face, whichever face the normal was taken from.
     */
    public final int[] feature = new int[2];

    /**
     * Gap in m to the edge of a chain that has no point yet, but may get one within the reach that
     * was looked: then {@link #normalX} is the edge's. Below 0 in all other cases.
     */
    public double beside = Pairs.NOT_AWAITED;

    /** What gave the normal. */
    public NormalSource source = NormalSource.CLOSEST_POINTS;

    /** Forgets all points. */
    void clear() {
        count = 0;
        beside = Pairs.NOT_AWAITED;
    }

    /** States the normal. */
    void normal(double x, double y, NormalSource from) {
        normalX = x;
        normalY = y;
        source = from;
    }

    /** Turns the normal from a shape's frame into the world's. */
    void turn(Pose pose) {
        double x = normalX;
        normalX = pose.cos * x - pose.sin * normalY;
        normalY = pose.sin * x + pose.cos * normalY;
    }

    /** Tells the same contact with A and B exchanged. */
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

    /** Makes of the contact of two cores that of the outlines at these radii in m round them. */
    void round(double radiusA, double radiusB) {
        double towardsB = (radiusA - radiusB) / 2;
        for (int i = 0; i < count; i++) {
            pointX[i] += towardsB * normalX;
            pointY[i] += towardsB * normalY;
            separation[i] -= radiusA + radiusB;
        }
    }

    /** Appends a point: world place in m, gap in m and the name of its features. */
    void add(double x, double y, double gap, int name) {
        pointX[count] = x;
        pointY[count] = y;
        separation[count] = gap;
        feature[count] = name;
        count++;
    }
}
