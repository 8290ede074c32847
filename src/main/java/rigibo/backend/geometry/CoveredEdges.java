package rigibo.backend.geometry;

import java.util.List;

/**
 * Which edges of a compound's part other parts cover, and which directions lead out of the compound
 * at the corners beside them. Nothing leaves a part through a covered edge, nor past the corner at
 * its end: where the next part continues the surface, what is above it touches that part.
 */
final class CoveredEdges {

    /** Distance from a corner at which the directions out of it are searched, in widths. */
    private static final double BESIDE = 1e-3;

    /** Halvings of a right angle, down to 1e-6 rad. */
    private static final int HALVINGS = 21;

    private final Outline outline;
    private final boolean[] isCovered;

    /** By edge: the outermost directions at its first and at its last corner. */
    private final double[] firstX;

    private final double[] firstY;
    private final double[] lastX;
    private final double[] lastY;

    /** Looks at the outline of a part with some covered edges among those of all parts. */
    CoveredEdges(Outline outline, boolean[] isCovered, List<Outline> others) {
        this.outline = outline;
        this.isCovered = isCovered;
        int edges = isCovered.length;
        firstX = new double[edges];
        firstY = new double[edges];
        lastX = new double[edges];
        lastY = new double[edges];
        for (int i = 0; i < edges; i++) {
            firstX[i] = outline.normalX(i);
            firstY[i] = outline.normalY(i);
            lastX[i] = outline.normalX(i);
            lastY[i] = outline.normalY(i);
            if (!isCovered[i]) {
                turnToSurface(i, others);
            }
        }
    }

    /** Turns the outermost directions of an edge to where the neighbouring part's surface goes. */
    private void turnToSurface(int edge, List<Outline> others) {
        double nx = outline.normalX(edge);
        double ny = outline.normalY(edge);
        if (isCovered[next(edge)]) {
            double turn = surfaceTurn(edge, next(edge), 1, others);
            lastX[edge] = Angle.cos(turn) * nx - Angle.sin(turn) * ny;
            lastY[edge] = Angle.sin(turn) * nx + Angle.cos(turn) * ny;
        }
        if (isCovered[previous(edge)]) {
            double turn = surfaceTurn(edge, edge, -1, others);
            firstX[edge] = Angle.cos(turn) * nx - Angle.sin(turn) * ny;
            firstY[edge] = Angle.sin(turn) * nx + Angle.cos(turn) * ny;
        }
    }

    /**
     * Angle in rad by which the surface turns away from an edge at a corner, positive at its end
     * and negative at its start (side 1 and -1); 0 where it goes straight on, or rises.
     */
    private double surfaceTurn(int edge, int corner, int side, List<Outline> others) {
        double reach = BESIDE * outline.smallestWidth();
        double alongX = -side * outline.normalY(edge) * reach;
        double alongY = side * outline.normalX(edge) * reach;
        double outside = 0;
        double inside = Math.PI / 2;
        for (int i = 0; i < HALVINGS; i++) {
            double turn = side * (outside + inside) / 2;
            double x =
                    outline.cornerX(corner) + Angle.cos(turn) * alongX - Angle.sin(turn) * alongY;
            double y =
                    outline.cornerY(corner) + Angle.sin(turn) * alongX + Angle.cos(turn) * alongY;
            if (isInAny(others, x, y)) {
                inside = (outside + inside) / 2;
            } else {
                outside = (outside + inside) / 2;
            }
        }
        return side * inside;
    }

    private static boolean isInAny(List<Outline> others, double x, double y) {
        for (Outline other : others) {
            if (other.depth(x, y) > 0) {
                return true;
            }
        }
        return false;
    }

    private int next(int edge) {
        return edge + 1 == isCovered.length ? 0 : edge + 1;
    }

    private int previous(int edge) {
        return edge == 0 ? isCovered.length - 1 : edge - 1;
    }

    boolean isCovered(int edge) {
        return isCovered[edge];
    }

    /**
     * Where a unit direction out of the part leads: {@link Outline#OUT}, {@link Outline#INSIDE}, or
     * past the surface at a corner of an edge, twice its number and 1 more at its end; by an angle
     * whose sine is greater than {@code sine}.
     */
    int leads(double x, double y, double sine) {
        for (int edge = 0; edge < isCovered.length; edge++) {
            double nx = outline.normalX(edge);
            double ny = outline.normalY(edge);
            double turned = nx * y - ny * x;
            if (Math.abs(turned) <= sine && nx * x + ny * y > 0) {
                return isCovered[edge] ? Outline.INSIDE : Outline.OUT;
            }
            int after = next(edge);
            if (turned > 0 && x * outline.normalY(after) - y * outline.normalX(after) > 0) {
                return leadsBetween(edge, after, x, y, sine);
            }
        }
        return Outline.OUT;
    }

    private int leadsBetween(int edge, int after, double x, double y, double sine) {
        if (isCovered[edge] && isCovered[after]) {
            return Outline.INSIDE;
        }
        if (isCovered[after] && lastX[edge] * y - lastY[edge] * x > sine) {
            return 2 * edge + 1;
        }
        if (isCovered[edge] && x * firstY[after] - y * firstX[after] > sine) {
            return 2 * after;
        }
        return Outline.OUT;
    }

    /** The outermost direction at a corner of an edge, as {@link #leads} tells it. */
    double outermostX(int corner) {
        return corner % 2 == 0 ? firstX[corner / 2] : lastX[corner / 2];
    }

    double outermostY(int corner) {
        return corner % 2 == 0 ? firstY[corner / 2] : lastY[corner / 2];
    }
}
