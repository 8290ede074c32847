package rigibo.backend.broadphase;

import rigibo.backend.storage.Slots;

import java.util.Arrays;

/**
 * A binary tree of boxes in flat columns. Leaves carry a number; a branch's box holds both its
 * children's. What a query finds depends on the boxes alone, never on the shape of the tree.
 *
 * <p>A leaf goes where it adds least perimeter (the surface area heuristic of Goldsmith and Salmon,
 * 1987), and branches are rotated on the way back up so that paths stay short.
 */
final class FixtureTree {

    static final int NONE = -1;

    private static final int FIRST_CAPACITY = 32;

    private final Slots slots = new Slots();
    private int root = NONE;
    private int[] parent = new int[FIRST_CAPACITY];

    /** Children of a branch; {@link #NONE} in the first marks a leaf. */
    private int[] left = new int[FIRST_CAPACITY];

    private int[] right = new int[FIRST_CAPACITY];

    /** Levels below a node, 0 for a leaf. */
    private int[] height = new int[FIRST_CAPACITY];

    /** A leaf's number. */
    private int[] number = new int[FIRST_CAPACITY];

    /** Boxes, four doubles per node: min x, min y, max x, max y. */
    private double[] box = new double[4 * FIRST_CAPACITY];

    private int[] stack = new int[64];

    /** Adds a box; returns its leaf. */
    int insert(int carried, double minX, double minY, double maxX, double maxY) {
        int leaf = take();
        number[leaf] = carried;
        left[leaf] = NONE;
        height[leaf] = 0;
        setBox(leaf, minX, minY, maxX, maxY);
        attach(leaf);
        return leaf;
    }

    /** Removes a leaf. */
    void remove(int leaf) {
        detach(leaf);
        slots.giveBack(leaf);
    }

    /** Gives a leaf another box. */
    void move(int leaf, double minX, double minY, double maxX, double maxY) {
        detach(leaf);
        setBox(leaf, minX, minY, maxX, maxY);
        attach(leaf);
    }

    /** Appends the numbers of all leaves whose box shares a point with this one. */
    void query(double minX, double minY, double maxX, double maxY, Found found) {
        int depth = 0;
        if (root != NONE) {
            stack[depth++] = root;
        }
        while (depth > 0) {
            int node = stack[--depth];
            int at = 4 * node;
            if (box[at] > maxX || box[at + 2] < minX || box[at + 1] > maxY || box[at + 3] < minY) {
                continue;
            }
            if (left[node] == NONE) {
                found.add(number[node]);
            } else {
                if (depth + 2 > stack.length) {
                    stack = Arrays.copyOf(stack, 2 * stack.length);
                }
                stack[depth++] = right[node];
                stack[depth++] = left[node];
            }
        }
    }

    private int take() {
        int node = slots.take();
        if (node == parent.length) {
            int capacity = 2 * node;
            parent = Arrays.copyOf(parent, capacity);
            left = Arrays.copyOf(left, capacity);
            right = Arrays.copyOf(right, capacity);
            height = Arrays.copyOf(height, capacity);
            number = Arrays.copyOf(number, capacity);
            box = Arrays.copyOf(box, 4 * capacity);
        }
        return node;
    }

    private void attach(int leaf) {
        if (root == NONE) {
            root = leaf;
            parent[leaf] = NONE;
            return;
        }
        int sibling = bestSibling(leaf);
        int branch = take();
        int above = parent[sibling];
        parent[branch] = above;
        left[branch] = sibling;
        right[branch] = leaf;
        parent[sibling] = branch;
        parent[leaf] = branch;
        replaceChild(above, sibling, branch);
        refitUp(branch);
    }

    private void detach(int leaf) {
        if (leaf == root) {
            root = NONE;
            return;
        }
        int branch = parent[leaf];
        int sibling = left[branch] == leaf ? right[branch] : left[branch];
        int above = parent[branch];
        parent[sibling] = above;
        replaceChild(above, branch, sibling);
        slots.giveBack(branch);
        refitUp(above);
    }

    private void replaceChild(int above, int old, int fresh) {
        if (above == NONE) {
            root = fresh;
        } else if (left[above] == old) {
            left[above] = fresh;
        } else {
            right[above] = fresh;
        }
    }

    /** Walks down towards less added perimeter until a node is the cheapest place itself. */
    private int bestSibling(int leaf) {
        int node = root;
        while (left[node] != NONE) {
            double here = perimeter(node);
            double merged = mergedPerimeter(node, leaf);
            double inherited = 2 * (merged - here);
            double costHere = 2 * merged;
            double costLeft = descentCost(left[node], leaf) + inherited;
            double costRight = descentCost(right[node], leaf) + inherited;
            if (costHere <= costLeft && costHere <= costRight) {
                return node;
            }
            node = costLeft <= costRight ? left[node] : right[node];
        }
        return node;
    }

    private double descentCost(int node, int leaf) {
        double merged = mergedPerimeter(node, leaf);
        return left[node] == NONE ? merged : merged - perimeter(node);
    }

    private void refitUp(int from) {
        int node = from;
        while (node != NONE) {
            rotate(node);
            merge(node);
            node = parent[node];
        }
    }

    /** Swaps a child with a grandchild of the other side where that shortens the longer path. */
    private void rotate(int node) {
        int l = left[node];
        int r = right[node];
        if (height[l] > height[r] + 1) {
            raiseFrom(node, l, r);
        } else if (height[r] > height[l] + 1) {
            raiseFrom(node, r, l);
        }
    }

    private void raiseFrom(int node, int tall, int shallow) {
        boolean leftIsTaller = height[left[tall]] >= height[right[tall]];
        int raised = leftIsTaller ? left[tall] : right[tall];
        replaceChild(node, shallow, raised);
        replaceChild(tall, raised, shallow);
        parent[raised] = node;
        parent[shallow] = tall;
        merge(tall);
    }

    private void merge(int node) {
        int l = 4 * left[node];
        int r = 4 * right[node];
        setBox(
                node,
                Math.min(box[l], box[r]),
                Math.min(box[l + 1], box[r + 1]),
                Math.max(box[l + 2], box[r + 2]),
                Math.max(box[l + 3], box[r + 3]));
        height[node] = 1 + Math.max(height[left[node]], height[right[node]]);
    }

    private void setBox(int node, double minX, double minY, double maxX, double maxY) {
        int at = 4 * node;
        box[at] = minX;
        box[at + 1] = minY;
        box[at + 2] = maxX;
        box[at + 3] = maxY;
    }

    private double perimeter(int node) {
        int at = 4 * node;
        return box[at + 2] - box[at] + box[at + 3] - box[at + 1];
    }

    private double mergedPerimeter(int node, int leaf) {
        int n = 4 * node;
        int m = 4 * leaf;
        return Math.max(box[n + 2], box[m + 2])
                - Math.min(box[n], box[m])
                + Math.max(box[n + 3], box[m + 3])
                - Math.min(box[n + 1], box[m + 1]);
    }
}
