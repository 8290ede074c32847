package rigibo.backend.broadphase;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.storage.Found;

import java.util.Arrays;

/**
 * Searches fixtures by box and by ray. Two searches of one tree do not disturb each other, since
 * each has scratch of its own.
 */
public final class FixtureSearch {

    private final FixtureTree tree;
    private final RayWalk walk;
    private final Found found = new Found();
    private int[] stack = new int[64];

    FixtureSearch(FixtureTree tree) {
        this.tree = tree;
        walk = new RayWalk(tree);
    }

    /**
     * The slots, ascending, of all shapes whose fixture shares a point with a box, m. The next
     * query overwrites the list.
     */
    public Found query(Aabb box) {
        return query(box.minX, box.minY, box.maxX, box.maxY);
    }

    Found query(double minX, double minY, double maxX, double maxY) {
        found.clear();
        collect(minX, minY, maxX, maxY, found);
        found.sort();
        return found;
    }

    /** Appends the fixtures that share a point with a box, in no order. */
    void collect(double minX, double minY, double maxX, double maxY, Found into) {
        double[] box = tree.boxes();
        int depth = push(0, tree.top());
        while (depth > 0) {
            int node = stack[--depth];
            int at = 4 * node;
            if (box[at] > maxX || box[at + 2] < minX || box[at + 1] > maxY || box[at + 3] < minY) {
                continue;
            }
            if (tree.isLeaf(node)) {
                into.add(tree.carried(node));
            } else {
                depth = push(push(depth, tree.second(node)), tree.first(node));
            }
        }
    }

    private int push(int depth, int node) {
        if (node == FixtureTree.NONE) {
            return depth;
        }
        if (depth == stack.length) {
            stack = Arrays.copyOf(stack, 2 * depth);
        }
        stack[depth] = node;
        return depth + 1;
    }

    /**
     * Begins a walk along a ray (m) over the fixtures that it crosses, which carry the slots of
     * their shapes. There is one walk at a time.
     */
    public RayWalk walk(double fromX, double fromY, double toX, double toY) {
        walk.begin(fromX, fromY, toX, toY);
        return walk;
    }

    /** Begins a walk of a box, in m relative to the moving point of the ray. */
    public RayWalk walk(Aabb box, double fromX, double fromY, double toX, double toY) {
        walk.begin(box, fromX, fromY, toX, toY);
        return walk;
    }
}
