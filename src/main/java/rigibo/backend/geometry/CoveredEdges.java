package rigibo.backend.geometry;

import java.util.List;

/**
 * Which edges of a compound's part are covered by other parts, and which directions lead out of the
 * compound at the corners beside them. Nothing leaves a part through a covered edge. Nor does
 * anything leave past a corner at which the next part continues the surface: what lies there
 * touches that part.
 */
final class CoveredEdges {

    /** Distance from a corner at which the directions out of it are searched, in widths. */
    private static final double BESIDE = 1e-3;

    /** Angle up to which a surface counts as going straight on, rad. */
    private static final double LEVEL = 1e-2;

    /** Two edges count as opposite if their normals' cosine is beyond this. */
    private static final double OPPOSITE = -0.99;

    /** Halvings of a right angle, down to 1e-6 rad. */
    private static final int HALVINGS = 21;

    /**
     * Length of a step through other parts, in widths; the last step is halved down to round-off.
     */
    private static final double THICKNESS_STEP = 0.1;

    private static final int FINE_HALVINGS = 50;

    private final Outline outline;
    private final List<Outline> others;
    private final boolean[] isCovered;

    /**
     * The outermost direction at each corner. A corner's index is twice its edge's, plus 1 at the
     * edge's end.
     */
    private final double[] outermostX;

    private final double[] outermostY;

    /** By corner: whether the neighbouring part rises there. */
    private final boolean[] rises;

    /** Looks at the outline of a part with some covered edges among those of all parts. */
    CoveredEdges(Outline outline, boolean[] isCovered, List<Outline> others) {
        this.outline = outline;
        this.isCovered = isCovered;
        this.others = others;
        int corners = 2 * isCovered.length;
        outermostX = new double[corners];
        outermostY = new double[corners];
        rises = new boolean[corners];
        for (int i = 0; i < isCovered.length; i++) {
            if (!isCovered[i]) {
                if (isCovered[previous(i)]) {
                    follow(2 * i);
                }
                if (isCovered[next(i)]) {
                    follow(2 * i + 1);
                }
            }
        }
    }

    /** Follows the surface from a corner to where the neighbouring part goes on with it. */
    private void follow(int corner) {
        int edge = corner / 2;
        double turn = corner % 2 == 0 ? -surfaceTurn(corner) : surfaceTurn(corner);
        double nx = outline.normalX(edge);
        double ny = outline.normalY(edge);
        outermostX[corner] = Angle.cos(turn) * nx - Angle.sin(turn) * ny;
        outermostY[corner] = Angle.sin(turn) * nx + Angle.cos(turn) * ny;
        rises[corner] = isInside(corner, -LEVEL);
    }

    /** Angle in rad by which the surface turns away at a corner; about 0 where it does not. */
    private double surfaceTurn(int corner) {
        double outside = 0;
        double inside = Math.PI / 2;
        for (int i = 0; i < HALVINGS; i++) {
            double turn = (outside + inside) / 2;
            if (isInside(corner, turn)) {
                inside = turn;
            } else {
                outside = turn;
            }
        }
        return inside;
    }

    /**
     * Whether another part lies beside a corner, in the direction of the corner's edge turned
     * inwards by an angle in rad.
     */
    private boolean isInside(int corner, double angle) {
        double distance = BESIDE * outline.smallestWidth();
        int edge = corner / 2;
        boolean isEnd = corner % 2 == 1;
        int side = isEnd ? 1 : -1;
        int at = isEnd ? next(edge) : edge;
        double alongX = -side * outline.normalY(edge) * distance;
        double alongY = side * outline.normalX(edge) * distance;
        double cos = Angle.cos(side * angle);
        double sin = Angle.sin(side * angle);
        double x = outline.cornerX(at) + cos * alongX - sin * alongY;
        double y = outline.cornerY(at) + sin * alongX + cos * alongY;
        return isInAny(x, y);
    }

    private boolean isInAny(double x, double y) {
        return isInAny(others, x, y);
    }

    /** Whether a point lies in one of these outlines. */
    static boolean isInAny(List<Outline> outlines, double x, double y) {
        for (Outline outline : outlines) {
            if (outline.depth(x, y) > 0) {
                return true;
            }
        }
        return false;
    }

    /**
     * Smallest width in m of the body at this part; infinite if all edges are covered. Where
     * another part covers the opposite edge, the width reaches from the middle of an edge through
     * that part.
     */
    double openWidth() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < isCovered.length; i++) {
            if (!isCovered[i]) {
                least = Math.min(least, goesOnOpposite(i) ? thickness(i) : outline.extent(i));
            }
        }
        return least + 2 * outline.radius();
    }

    private boolean goesOnOpposite(int edge) {
        boolean goesOn = false;
        for (int i = 0; i < isCovered.length; i++) {
            double along =
                    outline.normalX(edge) * outline.normalX(i)
                            + outline.normalY(edge) * outline.normalY(i);
            goesOn |= isCovered[i] && along < OPPOSITE;
        }
        return goesOn;
    }

    /** Distance in m from the middle of an edge straight through all parts to the other side. */
    private double thickness(int edge) {
        double inside = outline.extent(edge);
        double step = THICKNESS_STEP * outline.smallestWidth();
        while (isInAny(edge, inside + step)) {
            inside += step;
        }
        double outside = inside + step;
        for (int i = 0; i < FINE_HALVINGS; i++) {
            double middle = (inside + outside) / 2;
            if (isInAny(edge, middle)) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return inside;
    }

    /** Whether another part lies the given distance (m) below the middle of an edge. */
    private boolean isInAny(int edge, double below) {
        double x = (outline.cornerX(edge) + outline.cornerX(next(edge))) / 2;
        double y = (outline.cornerY(edge) + outline.cornerY(next(edge))) / 2;
        return isInAny(x - below * outline.normalX(edge), y - below * outline.normalY(edge));
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
     * the index of the corner at which it passes the surface by an angle whose sine is greater than
     * {@code sine}.
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
        int end = 2 * edge + 1;
        if (isCovered[after] && outermostX[end] * y - outermostY[end] * x > sine) {
            return end;
        }
        int start = 2 * after;
        if (isCovered[edge] && x * outermostY[start] - y * outermostX[start] > sine) {
            return start;
        }
        return Outline.OUT;
    }

    /** The outermost direction at a corner, as {@link #leads} tells it. */
    double outermostX(int corner) {
        return outermostX[corner];
    }

    double outermostY(int corner) {
        return outermostY[corner];
    }

    /** Whether the neighbouring part rises at a corner. */
    boolean rises(int corner) {
        return rises[corner];
    }
}
