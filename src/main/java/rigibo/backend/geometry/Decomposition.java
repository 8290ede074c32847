package rigibo.backend.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * Cuts a simple polygon into convex pieces. Ears are cut off until a triangle is left; then two
 * pieces are joined again across every diagonal whose removal leaves a convex piece. This gives at
 * most four times as many pieces as necessary (S. Hertel and K. Mehlhorn, 1983).
 */
final class Decomposition {

    private static final String MAKER = "Compound.ofOutline";

    private final double[] xy;

    /** Corner indices of each piece, counter-clockwise. */
    private final List<int[]> pieces = new ArrayList<>();

    /** The two end corners of each cut. */
    private final List<int[]> diagonals = new ArrayList<>();

    private Decomposition(double[] xy) {
        this.xy = xy;
    }

    /**
     * The convex pieces of an outline.
     *
     * @throws IllegalArgumentException naming the corner or the edges at fault
     */
    static List<Polygon> of(double[] outline) {
        requireSimple(outline);
        Decomposition cut = new Decomposition(outline);
        cut.cutEars();
        cut.diagonals.forEach(cut::join);
        List<Polygon> polygons = new ArrayList<>();
        for (int[] piece : cut.pieces) {
            double[] corners = new double[2 * piece.length];
            for (int i = 0; i < piece.length; i++) {
                corners[2 * i] = outline[2 * piece[i]];
                corners[2 * i + 1] = outline[2 * piece[i] + 1];
            }
            polygons.add(Polygon.of(corners));
        }
        return polygons;
    }

    private void cutEars() {
        List<Integer> left = new ArrayList<>();
        for (int i = 0; i < xy.length / 2; i++) {
            left.add(i);
        }
        while (left.size() > 3) {
            int ear = bluntestEar(left);
            int count = left.size();
            int before = left.get((ear + count - 1) % count);
            int after = left.get((ear + 1) % count);
            pieces.add(new int[] {before, left.get(ear), after});
            diagonals.add(new int[] {before, after});
            left.remove(ear);
        }
        pieces.add(new int[] {left.get(0), left.get(1), left.get(2)});
    }

    /** The ear whose triangle has the largest smallest angle, to avoid slivers. */
    private int bluntestEar(List<Integer> left) {
        int best = 0;
        double bluntest = 0;
        for (int i = 0; i < left.size(); i++) {
            int before = left.get((i + left.size() - 1) % left.size());
            int tip = left.get(i);
            int after = left.get((i + 1) % left.size());
            double blunt = leastSine(before, tip, after);
            if (blunt > bluntest && isEmpty(left, before, tip, after)) {
                bluntest = blunt;
                best = i;
            }
        }
        if (!(bluntest > 0)) {
            throw new IllegalArgumentException(
                    MAKER + " cannot be cut into pieces: parts of it are narrower than round-off");
        }
        return best;
    }

    /** Sine of the smallest angle of a triangle; 0 or less where the triangle is clockwise. */
    private double leastSine(int a, int b, int c) {
        double ab = length(a, b);
        double bc = length(b, c);
        double ca = length(c, a);
        return turn(a, b, c) * Math.min(ab, Math.min(bc, ca)) / (ab * bc * ca);
    }

    private boolean isEmpty(List<Integer> left, int a, int b, int c) {
        for (int p : left) {
            boolean isCorner = p == a || p == b || p == c;
            if (!isCorner && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** Joins the two pieces at a diagonal if the result is convex. */
    private void join(int[] diagonal) {
        int[] one = pieceWith(diagonal[1], diagonal[0]);
        int[] other = pieceWith(diagonal[0], diagonal[1]);
        int[] joined = joined(one, indexOf(one, diagonal[0]), other, indexOf(other, diagonal[1]));
        if (isConvex(joined)) {
            pieces.remove(one);
            pieces.remove(other);
            pieces.add(joined);
        }
    }

    /** The piece with an edge from one corner to another. */
    private int[] pieceWith(int from, int to) {
        for (int[] piece : pieces) {
            int at = indexOf(piece, from);
            if (at >= 0 && piece[(at + 1) % piece.length] == to) {
                return piece;
            }
        }
        throw new AssertionError("every diagonal has a piece on either side");
    }

    private static int indexOf(int[] piece, int corner) {
        for (int i = 0; i < piece.length; i++) {
            if (piece[i] == corner) {
                return i;
            }
        }
        return -1;
    }

    /**
     * The corners of the first piece, from the diagonal's start round to its other end, then those
     * of the second.
     */
    private static int[] joined(int[] one, int from, int[] other, int fromOther) {
        int[] joined = new int[one.length + other.length - 2];
        for (int i = 0; i < one.length - 1; i++) {
            joined[i] = one[(from + i) % one.length];
        }
        for (int i = 0; i < other.length - 1; i++) {
            joined[one.length - 1 + i] = other[(fromOther + i) % other.length];
        }
        return joined;
    }

    private boolean isConvex(int[] piece) {
        int count = piece.length;
        boolean isConvex = count <= Polygon.MAX_CORNERS;
        for (int i = 0; i < count && isConvex; i++) {
            int b = piece[(i + 1) % count];
            int c = piece[(i + 2) % count];
            isConvex =
                    turn(piece[i], b, c)
                            > PolygonCheck.LEAST_SINE * length(piece[i], b) * length(b, c);
        }
        return isConvex;
    }

    /** Twice the signed area of a triangle, m²; negative if it is clockwise. */
    private double turn(int a, int b, int c) {
        return turn(xy, a, xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]);
    }

    private static double turn(double[] xy, int a, double bx, double by, double cx, double cy) {
        double ax = xy[2 * a];
        double ay = xy[2 * a + 1];
        return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    }

    private double length(int a, int b) {
        double dx = xy[2 * b] - xy[2 * a];
        double dy = xy[2 * b + 1] - xy[2 * a + 1];
        return Math.sqrt(dx * dx + dy * dy);
    }

    private static void requireSimple(double[] xy) {
        PolygonCheck.requirePresent(MAKER + " xy", xy);
        PolygonCheck.requireCount(MAKER, xy);
        PolygonCheck.requireFinite(MAKER, xy);
        int count = xy.length / 2;
        double area = 0;
        for (int i = 0; i < count; i++) {
            int next = (i + 1) % count;
            if (xy[2 * i] == xy[2 * next] && xy[2 * i + 1] == xy[2 * next + 1]) {
                throw new IllegalArgumentException(
                        MAKER + " corner " + next + " is repeated at " + PolygonCheck.at(xy, next));
            }
            area += turn(xy, 0, xy[2 * i], xy[2 * i + 1], xy[2 * next], xy[2 * next + 1]);
        }
        for (int i = 0; i < count; i++) {
            for (int j = i + 2; j < count; j++) {
                requireApart(xy, i, j);
            }
        }
        if (!(area > 0)) {
            throw new IllegalArgumentException(
                    MAKER
                            + " corners must be counter-clockwise, twice their area was "
                            + area
                            + " m²");
        }
    }

    private static void requireApart(double[] xy, int first, int second) {
        int count = xy.length / 2;
        boolean areNeighbours = (second + 1) % count == first;
        boolean cross =
                spansOverlap(xy, 0, first, second)
                        && spansOverlap(xy, 1, first, second)
                        && isAcross(xy, first, second)
                        && isAcross(xy, second, first);
        if (cross && !areNeighbours) {
            throw new IllegalArgumentException(
                    MAKER
                            + " edges must not cross: those from corner "
                            + first
                            + " at "
                            + PolygonCheck.at(xy, first)
                            + " and from corner "
                            + second
                            + " at "
                            + PolygonCheck.at(xy, second)
                            + " do");
        }
    }

    /** Whether two edges overlap along an axis, 0 for x and 1 for y. */
    private static boolean spansOverlap(double[] xy, int axis, int first, int second) {
        double a = xy[2 * first + axis];
        double b = xy[(2 * first + 2 + axis) % xy.length];
        double c = xy[2 * second + axis];
        double d = xy[(2 * second + 2 + axis) % xy.length];
        return Math.min(a, b) <= Math.max(c, d) && Math.min(c, d) <= Math.max(a, b);
    }

    /** Whether the ends of one edge lie on different sides of the line of another, or on it. */
    private static boolean isAcross(double[] xy, int edge, int other) {
        int next = (edge + 1) % (xy.length / 2);
        int end = (other + 1) % (xy.length / 2);
        double nextX = xy[2 * next];
        double nextY = xy[2 * next + 1];
        double first = turn(xy, edge, nextX, nextY, xy[2 * other], xy[2 * other + 1]);
        double second = turn(xy, edge, nextX, nextY, xy[2 * end], xy[2 * end + 1]);
        return Math.min(first, second) <= 0 && Math.max(first, second) >= 0;
    }
}
