package rigibo.backend.force;

import rigibo.backend.geometry.Polygon;

import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;

/**
 * Area and moments of what of a shape is under a level, summed from level strips: a strip from x₁
 * to x₂ at the height y has w = x₂ − x₁ of area, its middle m in first moment and w·(y² + m²) +
 * w³/12 in second, per height. All of them are cubics in y between two corners, which Simpson's
 * rule integrates without error.
 */
final class Strips {

    /** Simpson's intervals over half a turn of a disc: an error of 1e-12. */
    private static final int DISC_INTERVALS = 4000;

    double area;
    double momentX;
    double momentY;
    double second;

    /** A polygon turned by an angle; the level is seen from its centre of mass. */
    static Strips of(Polygon polygon, double angle, double level) {
        double[] x = new double[polygon.corners()];
        double[] y = new double[polygon.corners()];
        for (int i = 0; i < x.length; i++) {
            x[i] = Math.cos(angle) * polygon.cornerX(i) - Math.sin(angle) * polygon.cornerY(i);
            y[i] = Math.sin(angle) * polygon.cornerX(i) + Math.cos(angle) * polygon.cornerY(i);
        }
        // Cut off at the level: what is higher leaves strips of no height.
        double[] heights = DoubleStream.of(y).map(at -> Math.min(at, level)).sorted().toArray();
        Strips sum = new Strips();
        for (int i = 0; i + 1 < heights.length; i++) {
            sum.add(x, y, heights[i], heights[i + 1]);
        }
        return sum;
    }

    /** A disc: its strips by the angle from its lowest point, y = −r·cos φ. */
    static Strips of(double r, double level) {
        Strips sum = new Strips();
        double last = Math.acos(Math.max(-1, Math.min(1, -level / r)));
        double h = last / DISC_INTERVALS;
        for (int i = 0; i <= DISC_INTERVALS; i++) {
            double weight = i == 0 || i == DISC_INTERVALS ? 1 : i % 2 == 0 ? 2 : 4;
            double half = r * Math.sin(i * h);
            sum.strip(-half, half, -r * Math.cos(i * h), weight * h / 3 * half);
        }
        return sum;
    }

    /**
     * Outermost points are linear in y between two heights: found at ¼ and ¾ and carried on, for at
     * a corner's own height a level side is both wide and not.
     */
    private void add(double[] x, double[] y, double low, double high) {
        double height = high - low;
        if (!(height > 0)) {
            return;
        }
        double lower = low + height / 4;
        double upper = high - height / 4;
        DoubleUnaryOperator left = line(lower, edge(x, y, lower, -1), upper, edge(x, y, upper, -1));
        DoubleUnaryOperator right = line(lower, edge(x, y, lower, 1), upper, edge(x, y, upper, 1));
        double middle = (low + high) / 2;
        strip(left.applyAsDouble(low), right.applyAsDouble(low), low, height / 6);
        strip(left.applyAsDouble(middle), right.applyAsDouble(middle), middle, height * 4 / 6);
        strip(left.applyAsDouble(high), right.applyAsDouble(high), high, height / 6);
    }

    private static DoubleUnaryOperator line(double y1, double x1, double y2, double x2) {
        return y -> x1 + (y - y1) / (y2 - y1) * (x2 - x1);
    }

    /** The outermost point of an outline at a height, on the right for 1 and on the left for −1. */
    private static double edge(double[] x, double[] y, double height, int side) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < x.length; i++) {
            int j = (i + 1) % x.length;
            if ((y[i] - height) * (y[j] - height) < 0) {
                double at = line(y[i], x[i], y[j], x[j]).applyAsDouble(height);
                most = Math.max(most, side * at);
            }
        }
        return side * most;
    }

    private void strip(double x1, double x2, double y, double thickness) {
        double w = x2 - x1;
        double m = (x1 + x2) / 2;
        area += thickness * w;
        momentX += thickness * w * m;
        momentY += thickness * w * y;
        second += thickness * (w * (y * y + m * m) + w * w * w / 12);
    }
}
