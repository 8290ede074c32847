package rigibo.frontend.puzzle.level;

/**
 * How deep two placed bodies are in each other, by the separating axis theorem: two convex shapes
 * are apart exactly when one of their edge normals (for a disc also the direction to the nearest
 * corner) has a gap. The engine's own manifolds stay behind its door.
 */
final class Overlap {

    private Overlap() {}

    /** Depth in m; negative is the gap along the best edge normal, or the distance of a disc. */
    static double depth(Footprint a, Footprint b) {
        double[] cornersA = a.corners();
        double[] cornersB = b.corners();
        if (a.isDisc() && b.isDisc()) {
            double distance = Math.hypot(cornersA[0] - cornersB[0], cornersA[1] - cornersB[1]);
            return a.radius() + b.radius() - distance;
        }
        if (a.isDisc()) {
            return a.radius() - distance(cornersB, cornersA[0], cornersA[1]);
        }
        if (b.isDisc()) {
            return b.radius() - distance(cornersA, cornersB[0], cornersB[1]);
        }
        return -Math.max(widestGap(cornersA, cornersB), widestGap(cornersB, cornersA));
    }

    /** The widest gap from an edge of the first polygon outwards to the second. */
    private static double widestGap(double[] first, double[] second) {
        double widest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < first.length; i += 2) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int j = 0; j < second.length; j += 2) {
                nearest = Math.min(nearest, area(first, i, second[j], second[j + 1]));
            }
            widest = Math.max(widest, nearest / length(first, i));
        }
        return widest;
    }

    /** How far a point lies outside the edge that begins at this index. */
    private static double ahead(double[] xy, int i, double x, double y) {
        return area(xy, i, x, y) / length(xy, i);
    }

    /** That distance times the edge's length: the area of the parallelogram between them. */
    private static double area(double[] xy, int i, double x, double y) {
        int next = (i + 2) % xy.length;
        return (x - xy[i]) * (xy[next + 1] - xy[i + 1]) - (y - xy[i + 1]) * (xy[next] - xy[i]);
    }

    private static double length(double[] xy, int i) {
        int next = (i + 2) % xy.length;
        return Math.hypot(xy[next] - xy[i], xy[next + 1] - xy[i + 1]);
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
