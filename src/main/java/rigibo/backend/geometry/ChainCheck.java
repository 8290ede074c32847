package rigibo.backend.geometry;

import java.util.Comparator;
import java.util.stream.IntStream;

/** Checks that a list of points is a chain, and names what is wrong with it. */
final class ChainCheck {

    /**
     * Sine of the angle between two edges below which the second counts as reversing along the
     * first.
     */
    private static final double RIGHT_BACK = 1e-6;

    private final String maker;
    private final double[] xy;
    private final int edges;
    private final boolean isLoop;

    private ChainCheck(String maker, double[] xy, boolean isLoop) {
        this.maker = maker;
        this.xy = xy;
        this.isLoop = isLoop;
        edges = xy.length / 2 - (isLoop ? 0 : 1);
    }

    static void require(String maker, double[] xy, boolean isLoop) {
        PolygonCheck.requirePresent(maker + " xy", xy);
        ChainCheck check = new ChainCheck(maker, xy, isLoop);
        check.requireCount();
        PolygonCheck.requireFinite(maker, xy);
        for (int i = 0; i < check.edges; i++) {
            check.requireLength(i);
        }
        int bends = isLoop ? check.edges : check.edges - 1;
        for (int i = 0; i < bends; i++) {
            check.requireBend(i);
        }
        check.requireApart();
    }

    private void requireCount() {
        int least = isLoop ? 3 : 2;
        int most = Chain.MAX_EDGES + (isLoop ? 0 : 1);
        if (xy.length % 2 != 0 || xy.length < 2 * least || xy.length > 2 * most) {
            throw new IllegalArgumentException(
                    maker
                            + " takes x, y pairs of "
                            + least
                            + " to "
                            + most
                            + " corners, was "
                            + xy.length
                            + " numbers");
        }
    }

    private void requireLength(int edge) {
        double length = Length.hypot(endX(edge) - startX(edge), endY(edge) - startY(edge));
        if (!(length >= Chain.SHORTEST_EDGE && length < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    maker
                            + " edge "
                            + edge
                            + " from "
                            + PolygonCheck.at(xy, edge)
                            + " must be at least 0.1 mm long and finite, was "
                            + length
                            + " m");
        }
    }

    private void requireBend(int edge) {
        int next = (edge + 1) % edges;
        double ux = endX(edge) - startX(edge);
        double uy = endY(edge) - startY(edge);
        double wx = endX(next) - startX(next);
        double wy = endY(next) - startY(next);
        double lengths = Length.hypot(ux, uy) * Length.hypot(wx, wy);
        if (ux * wx + uy * wy < 0 && Math.abs(ux * wy - uy * wx) <= RIGHT_BACK * lengths) {
            throw new IllegalArgumentException(
                    maker + " must not go right back at corner " + next + named(next));
        }
    }

    /**
     * Checks that no two edges meet. Edges are sorted along the longer side, so that only those
     * near each other are compared.
     */
    private void requireApart() {
        boolean isWide = extent(0) >= extent(1);
        int axis = isWide ? 0 : 1;
        int[] sorted =
                IntStream.range(0, edges)
                        .boxed()
                        .sorted(Comparator.comparingDouble(edge -> least(edge, axis)))
                        .mapToInt(Integer::intValue)
                        .toArray();
        for (int i = 0; i < edges; i++) {
            double until = most(sorted[i], axis);
            for (int j = i + 1; j < edges && least(sorted[j], axis) <= until; j++) {
                requireApart(Math.min(sorted[i], sorted[j]), Math.max(sorted[i], sorted[j]));
            }
        }
    }

    private void requireApart(int one, int other) {
        boolean areNeighbours =
                other == one + 1 || isLoop && one == 0 && other == edges - 1 && edges > 2;
        if (!areNeighbours && meet(one, other)) {
            throw new IllegalArgumentException(
                    maker
                            + " must not cross or touch itself: edge "
                            + one
                            + named(one)
                            + " meets edge "
                            + other
                            + named(other));
        }
    }

    private boolean meet(int one, int other) {
        double side1 = side(one, startX(other), startY(other));
        double side2 = side(one, endX(other), endY(other));
        double side3 = side(other, startX(one), startY(one));
        double side4 = side(other, endX(one), endY(one));
        boolean boundsMeet =
                least(one, 0) <= most(other, 0)
                        && least(other, 0) <= most(one, 0)
                        && least(one, 1) <= most(other, 1)
                        && least(other, 1) <= most(one, 1);
        return boundsMeet && side1 * side2 <= 0 && side3 * side4 <= 0;
    }

    /** Side of an edge's line on which a point lies: 1 left, −1 right, 0 on the line. */
    private double side(int edge, double x, double y) {
        double dx = endX(edge) - startX(edge);
        double dy = endY(edge) - startY(edge);
        return Math.signum(dx * (y - startY(edge)) - dy * (x - startX(edge)));
    }

    private double extent(int axis) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = axis; i < xy.length; i += 2) {
            least = Math.min(least, xy[i]);
            most = Math.max(most, xy[i]);
        }
        return most - least;
    }

    private double least(int edge, int axis) {
        return Math.min(xy[2 * edge + axis], xy[(2 * edge + 2) % xy.length + axis]);
    }

    private double most(int edge, int axis) {
        return Math.max(xy[2 * edge + axis], xy[(2 * edge + 2) % xy.length + axis]);
    }

    private String named(int corner) {
        return " at " + PolygonCheck.at(xy, corner);
    }

    private double startX(int edge) {
        return xy[2 * edge];
    }

    private double startY(int edge) {
        return xy[2 * edge + 1];
    }

    private double endX(int edge) {
        return xy[(2 * edge + 2) % xy.length];
    }

    private double endY(int edge) {
        return xy[(2 * edge + 3) % xy.length];
    }
}
