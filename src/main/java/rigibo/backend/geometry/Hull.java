package rigibo.backend.geometry;

import java.util.Comparator;
import java.util.stream.IntStream;

/** Convex hull of points by the monotone chain (A. M. Andrew, 1979). */
final class Hull {

    private final double[] xy;

    /** Indices of the corners found so far. */
    private final int[] chain;

    private int count;

    private Hull(double[] xy) {
        this.xy = xy;
        chain = new int[xy.length];
    }

    /**
     * The corners of the hull, counter-clockwise; fewer than three if all points lie on one line.
     */
    static double[] of(double[] xy) {
        PolygonCheck.requirePresent("Polygon.hull xy", xy);
        if (xy.length % 2 != 0) {
            throw new IllegalArgumentException(
                    "Polygon.hull takes x, y pairs, was " + xy.length + " numbers");
        }
        PolygonCheck.requireFinite("Polygon.hull", xy);
        return new Hull(xy).corners();
    }

    private double[] corners() {
        int[] order =
                IntStream.range(0, xy.length / 2)
                        .boxed()
                        .sorted(
                                Comparator.<Integer>comparingDouble(i -> xy[2 * i])
                                        .thenComparingDouble(i -> xy[2 * i + 1]))
                        .mapToInt(Integer::intValue)
                        .toArray();
        for (int i = 0; i < order.length; i++) {
            add(order[i], 0);
        }
        int lower = count - 1;
        for (int i = order.length - 2; i >= 0; i--) {
            add(order[i], lower);
        }
        double[] corners = new double[2 * Math.max(0, count - 1)];
        for (int i = 0; i + 1 < count; i++) {
            corners[2 * i] = xy[2 * chain[i]];
            corners[2 * i + 1] = xy[2 * chain[i] + 1];
        }
        return corners;
    }

    /**
     * Adds a point to the chain that begins at index {@code from}, and removes the points that are
     * no longer corners.
     */
    private void add(int point, int from) {
        while (count - from >= 2 && !turnsLeft(chain[count - 2], chain[count - 1], point)) {
            count--;
        }
        chain[count++] = point;
    }

    private boolean turnsLeft(int a, int b, int c) {
        double ux = xy[2 * b] - xy[2 * a];
        double uy = xy[2 * b + 1] - xy[2 * a + 1];
        double wx = xy[2 * c] - xy[2 * b];
        double wy = xy[2 * c + 1] - xy[2 * b + 1];
        double lengths = Math.sqrt(ux * ux + uy * uy) * Math.sqrt(wx * wx + wy * wy);
        return ux * wy - uy * wx > PolygonCheck.LEAST_SINE * lengths;
    }
}
