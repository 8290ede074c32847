package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.ShapeKind;
import rigibo.backend.setup.BodyDefinition;

/**
 * How deep two placed bodies are in each other, by the separating axis theorem: two convex shapes
 * are apart exactly when one of their edge normals (for a disc also the direction to the nearest
 * corner) has a gap. The engine's own manifolds stay behind its door.
 */
final class Overlap {

    private Overlap() {}

    /** Depth in m; negative is the gap along the best edge normal, or the distance of a disc. */
    static double depth(BodyDefinition a, BodyDefinition b) {
        boolean isDiscA = a.shape().kind() == ShapeKind.CIRCLE;
        boolean isDiscB = b.shape().kind() == ShapeKind.CIRCLE;
        if (isDiscA && isDiscB) {
            double distance = Math.hypot(a.x() - b.x(), a.y() - b.y());
            return radius(a) + radius(b) - distance;
        }
        if (isDiscA) {
            return radius(a) - distance(corners(b), a.x(), a.y());
        }
        if (isDiscB) {
            return radius(b) - distance(corners(a), b.x(), b.y());
        }
        double[] cornersA = corners(a);
        double[] cornersB = corners(b);
        return -Math.max(widestGap(cornersA, cornersB), widestGap(cornersB, cornersA));
    }

    private static double radius(BodyDefinition disc) {
        return ((Circle) disc.shape()).radius();
    }

    /** World corners x₀, y₀, x₁, … */
    private static double[] corners(BodyDefinition placed) {
        Polygon polygon = (Polygon) placed.shape();
        double cos = StrictMath.cos(placed.angle());
        double sin = StrictMath.sin(placed.angle());
        double[] xy = new double[2 * polygon.corners()];
        for (int i = 0; i < polygon.corners(); i++) {
            double x = polygon.cornerX(i);
            double y = polygon.cornerY(i);
            xy[2 * i] = placed.x() + cos * x - sin * y;
            xy[2 * i + 1] = placed.y() + sin * x + cos * y;
        }
        return xy;
    }

    /** The widest gap from an edge of the first polygon outwards to the second. */
    private static double widestGap(double[] first, double[] second) {
        double widest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < first.length; i += 2) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int j = 0; j < second.length; j += 2) {
                nearest = Math.min(nearest, ahead(first, i, second[j], second[j + 1]));
            }
            widest = Math.max(widest, nearest);
        }
        return widest;
    }

    /** How far a point lies outside the edge that begins at this index. */
    private static double ahead(double[] xy, int i, double x, double y) {
        int next = (i + 2) % xy.length;
        double edgeX = xy[next] - xy[i];
        double edgeY = xy[next + 1] - xy[i + 1];
        return ((x - xy[i]) * edgeY - (y - xy[i + 1]) * edgeX) / Math.hypot(edgeX, edgeY);
    }

    /** Distance of a point to a polygon; inside, minus the depth to the nearest edge. */
    private static double distance(double[] xy, double x, double y) {
        double outside = Double.NEGATIVE_INFINITY;
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < xy.length; i += 2) {
            outside = Math.max(outside, ahead(xy, i, x, y));
            nearest = Math.min(nearest, distanceToEdge(xy, i, x, y));
        }
        return outside <= 0 ? outside : nearest;
    }

    private static double distanceToEdge(double[] xy, int i, double x, double y) {
        int next = (i + 2) % xy.length;
        double edgeX = xy[next] - xy[i];
        double edgeY = xy[next + 1] - xy[i + 1];
        double along =
                ((x - xy[i]) * edgeX + (y - xy[i + 1]) * edgeY) / (edgeX * edgeX + edgeY * edgeY);
        double t = Math.max(0, Math.min(1, along));
        return Math.hypot(x - xy[i] - t * edgeX, y - xy[i + 1] - t * edgeY);
    }
}
