package rigibo.backend.broadphase;

import rigibo.backend.geometry.Aabb;

import java.util.Arrays;

/**
 * Walks along a ray, or along the path of a moving box, from leaf to leaf of a tree. Of two
 * branches it visits the one entered earlier first, and it skips a branch that is entered too late.
 * So the cost grows with the distance to the first body hit, not with the box that the ray spans.
 */
public final class RayWalk {

    /** Returned when no more leaves follow. */
    public static final int END = -1;

    /** Returned for a box that the ray does not cross. */
    private static final double MISS = Double.POSITIVE_INFINITY;

    /**
     * Margin for a branch, so that round-off cannot exclude a branch while it admits a leaf in it.
     */
    private static final double ROUNDING_MARGIN = 1 + 1e-9;

    /**
     * Relative round-off of the products whose difference is the distance at which the ray passes a
     * box.
     */
    private static final double ROUNDING = 1e-15;

    /**
     * Share of the ray, 1 mm in 1,000 km, by which a box may be entered after the latest hit: far
     * more than the round-off of a hit point, and yet so little that it admits hardly any other
     * body.
     */
    private static final double SLACK = 1e-9;

    private final FixtureTree tree;
    private double fromX;
    private double fromY;
    private double dx;
    private double dy;
    private double minX;
    private double minY;
    private double maxX;
    private double maxY;

    /** The box that moves along the ray, relative to the ray's point, m; all 0 for a plain ray. */
    private double left;

    private double bottom;
    private double right;
    private double top;

    /** Nodes still to visit, the next one last, and the fractions at which the ray enters them. */
    private int[] stack = new int[64];

    private double[] entries = new double[64];
    private int depth;
    private int nodes;

    RayWalk(FixtureTree tree) {
        this.tree = tree;
    }

    /** Begins a walk from one point (m) to another. */
    void begin(double fromX, double fromY, double toX, double toY) {
        carry(0, 0, 0, 0);
        setOut(fromX, fromY, toX, toY);
    }

    /**
     * Begins a walk of a box, in m relative to the point that moves from the first place to the
     * second.
     */
    void begin(Aabb box, double fromX, double fromY, double toX, double toY) {
        carry(box.minX, box.minY, box.maxX, box.maxY);
        setOut(fromX, fromY, toX, toY);
    }

    private void carry(double left, double bottom, double right, double top) {
        this.left = left;
        this.bottom = bottom;
        this.right = right;
        this.top = top;
    }

    private void setOut(double fromX, double fromY, double toX, double toY) {
        this.fromX = fromX;
        this.fromY = fromY;
        dx = toX - fromX;
        dy = toY - fromY;
        minX = Math.min(fromX, toX);
        minY = Math.min(fromY, toY);
        maxX = Math.max(fromX, toX);
        maxY = Math.max(fromY, toY);
        depth = 0;
        nodes = 0;
        if (tree.top() != FixtureTree.NONE) {
            push(tree.top(), entry(tree.top()));
        }
    }

    /**
     * The number carried by the next leaf whose box the ray enters at or before a fraction of its
     * length, or {@link #END}.
     */
    public int next(double latest) {
        while (depth > 0) {
            int node = stack[--depth];
            if (entries[depth] > latest + SLACK) {
                continue;
            }
            if (tree.isLeaf(node)) {
                return tree.carried(node);
            }
            pushChildren(tree.first(node), tree.second(node));
        }
        return END;
    }

    /** Number of nodes whose box was compared with the ray since the walk began. */
    public int nodes() {
        return nodes;
    }

    private void pushChildren(int one, int two) {
        double entryOne = entry(one);
        double entryTwo = entry(two);
        boolean isOneFirst = entryOne <= entryTwo;
        push(isOneFirst ? two : one, isOneFirst ? entryTwo : entryOne);
        push(isOneFirst ? one : two, isOneFirst ? entryOne : entryTwo);
    }

    private void push(int node, double entry) {
        if (entry == MISS) {
            return;
        }
        if (depth == stack.length) {
            stack = Arrays.copyOf(stack, 2 * depth);
            entries = Arrays.copyOf(entries, 2 * depth);
        }
        stack[depth] = node;
        entries[depth++] = entry;
    }

    /**
     * The fraction at which the ray enters a node's box, 0 where it starts inside, or {@link
     * #MISS}.
     */
    private double entry(int node) {
        nodes++;
        double[] box = tree.boxes();
        int at = 4 * node;
        double boxMinX = box[at] - right;
        double boxMinY = box[at + 1] - top;
        double boxMaxX = box[at + 2] - left;
        double boxMaxY = box[at + 3] - bottom;
        if (boxMinX > maxX || boxMaxX < minX || boxMinY > maxY || boxMaxY < minY) {
            return MISS;
        }
        if (isBeside(boxMinX, boxMinY, boxMaxX, boxMaxY)) {
            return MISS;
        }
        double entryX = entry(fromX, dx, boxMinX, boxMaxX);
        double entryY = entry(fromY, dy, boxMinY, boxMaxY);
        return Math.max(0, Math.max(entryX, entryY));
    }

    private static double entry(double from, double way, double min, double max) {
        return way == 0 ? 0 : ((way > 0 ? min : max) - from) / way;
    }

    /** Whether there is a gap between the box and the ray, seen along the ray's normal. */
    private boolean isBeside(double boxMinX, double boxMinY, double boxMaxX, double boxMaxY) {
        double middleX = (boxMinX + boxMaxX) / 2 - fromX;
        double middleY = (boxMinY + boxMaxY) / 2 - fromY;
        double one = dx * middleY;
        double two = dy * middleX;
        double across = Math.abs(dx) * (boxMaxY - boxMinY);
        across += Math.abs(dy) * (boxMaxX - boxMinX);
        double rounding = ROUNDING * (Math.abs(one) + Math.abs(two));
        return Math.abs(one - two) > across / 2 * ROUNDING_MARGIN + rounding;
    }
}
