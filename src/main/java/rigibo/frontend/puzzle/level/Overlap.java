package rigibo.frontend.puzzle.level;

import rigibo.backend.geometry.Length;

/**
 * Depth of the overlap of two placed bodies: that of their two deepest parts. Overlapping cores are
 * measured along the edge normal with the least depth (separating axis theorem), separate cores by
 * the nearest corner of one and edge of the other; the radii are added. Nothing is allocated, since
 * a file may hold half a million pairs.
 */
final class Overlap {

    private Overlap() {}

    /** Depth in m; negative if the bodies are apart. */
    static double depth(Footprint a, Footprint b) {
        double deepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < a.corners().length; i++) {
            for (int j = 0; j < b.corners().length; j++) {
                double cores = depth(a.corners()[i], b.corners()[j]);
                deepest = Math.max(deepest, cores + a.radius(i) + b.radius(j));
            }
        }
        return deepest;
    }

    private static double depth(double[] a, double[] b) {
        double gap = Math.max(widestGap(a, b), widestGap(b, a));
        return gap < 0 ? -gap : -Math.min(distance(a, b), distance(b, a));
    }

    /**
     * The widest gap from an edge of the first core outwards to the second; a point has no edge.
     */
    private static double widestGap(double[] first, double[] second) {
        double widest = Double.NEGATIVE_INFINITY;
        for (int i = 0; first.length > 2 && i < first.length; i += 2) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int j = 0; j < second.length; j += 2) {
                nearest = Math.min(nearest, area(first, i, second[j], second[j + 1]));
            }
            widest = Math.max(widest, nearest / length(first, i));
        }
        return first.length > 2 || second.length > 2 ? widest : 0;
    }

    /** Distance of a point outside the edge that begins at this index, times the edge's length. */
    private static double area(double[] xy, int i, double x, double y) {
        int next = (i + 2) % xy.length;
        return (x - xy[i]) * (xy[next + 1] - xy[i + 1]) - (y - xy[i + 1]) * (xy[next] - xy[i]);
    }

    private static double length(double[] xy, int i) {
        int next = (i + 2) % xy.length;
        return Length.hypot(xy[next] - xy[i], xy[next + 1] - xy[i + 1]);
    }

    /** Least distance from the edges of the first core to the corners of the second. */
    private static double distance(double[] first, double[] second) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < first.length; i += 2) {
            for (int j = 0; j < second.length; j += 2) {
                nearest = Math.min(nearest, distanceToEdge(first, i, second[j], second[j + 1]));
            }
        }
        return nearest;
    }

    private static double distanceToEdge(double[] xy, int i, double x, double y) {
        int next = (i + 2) % xy.length;
        double edgeX = xy[next] - xy[i];
        double edgeY = xy[next + 1] - xy[i + 1];
        double square = edgeX * edgeX + edgeY * edgeY;
        double along = (x - xy[i]) * edgeX + (y - xy[i + 1]) * edgeY;
        double t = square > 0 ? Math.max(0, Math.min(1, along / square)) : 0;
        return Length.hypot(x - xy[i] - t * edgeX, y - xy[i + 1] - t * edgeY);
    }
}
