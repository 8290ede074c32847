package rigibo.backend.broadphase;

import rigibo.backend.storage.Growth;
import rigibo.backend.storage.Slots;

import java.util.Arrays;

/**
 * A binary tree of boxes in flat columns. Leaves carry a number; the box of a branch holds those of
 * both its children. The result of a query depends on the boxes alone, never on the shape of the
 * tree.
 *
 * <p>A leaf is inserted where it adds least perimeter to the branches (the surface area heuristic
 * of J. Goldsmith and J. Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, 1987);
 * on the way back up, a child changes places with a grandchild wherever that shrinks a branch.
 * Depth is not balanced: balancing was measured to make queries 100 times slower after 200 steps of
 * 20,000 moving bodies, because it puts distant bodies under one branch.
 */
final class FixtureTree {

    static final int NONE = -1;

    private static final int FIRST_CAPACITY = 32;

    /** Greatest number of branches examined for a place. */
    private static final int MOST_LOOKED = 128;

    private final Slots slots = new Slots();
    private int root = NONE;

    /** See {@link #searchAlso}. These nodes lie above all slots that were ever assigned. */
    private int top = NONE;

    private int nextSearched;

    private int[] parent = new int[FIRST_CAPACITY];

    /** Two per node: the children of a branch; for a leaf {@link #NONE} and its number. */
    private int[] child = new int[2 * FIRST_CAPACITY];

    /** Boxes, four doubles per node: min x, min y, max x, max y. */
    private double[] box = new double[4 * FIRST_CAPACITY];

    /** Branches to examine for a place, and the perimeter that the place adds above them, m. */
    private int[] places = new int[64];

    private double[] added = new double[64];

    /** Adds a box with a number; returns its leaf. */
    int insert(int carried, double minX, double minY, double maxX, double maxY) {
        int leaf = take();
        setLeaf(leaf, carried);
        setBox(leaf, minX, minY, maxX, maxY);
        attach(leaf, root);
        return leaf;
    }

    /** Removes a leaf. */
    void remove(int leaf) {
        detach(leaf);
        slots.giveBack(leaf);
    }

    /**
     * Gives a leaf another box. Within the branch two levels up the leaf keeps its place, and
     * rotations repair the cost; a leaf that left it is inserted again, under the lowest branch
     * that holds its new box.
     */
    void move(int leaf, double minX, double minY, double maxX, double maxY) {
        top = NONE;
        setBox(leaf, minX, minY, maxX, maxY);
        int above = parent[leaf];
        int top = above == NONE ? NONE : parent[above];
        if (top != NONE && holds(top, leaf)) {
            growUp(above);
        } else {
            detach(leaf);
            attach(leaf, holderOf(leaf, top));
        }
    }

    /** Becomes a copy of another tree that can be searched but not changed: it has no parents. */
    void copy(FixtureTree from) {
        int nodes = from.top == NONE ? from.slots.high : from.nextSearched;
        if (2 * nodes > child.length) {
            child = new int[from.child.length];
            box = new double[from.box.length];
        }
        root = from.top();
        System.arraycopy(from.child, 0, child, 0, 2 * nodes);
        System.arraycopy(from.box, 0, box, 0, 4 * nodes);
    }

    int root() {
        return root;
    }

    /** First node of a search: the root, the node of {@link #searchAlso}, or {@link #NONE}. */
    int top() {
        return top == NONE ? root : top;
    }

    /** Makes room for nodes that are searched until the tree changes; former ones are dropped. */
    void makeRoomForSearched(int nodes) {
        forgetSearched();
        nextSearched = slots.high;
        makeRoom(slots.high + nodes);
    }

    /** Adds such a leaf with a number and a box, four values from an index on; returns the leaf. */
    int addSearchedLeaf(int carried, double[] boxes, int at) {
        int leaf = nextSearched++;
        setLeaf(leaf, carried);
        System.arraycopy(boxes, at, box, 4 * leaf, 4);
        return leaf;
    }

    /** Adds a branch over two such nodes; returns it. */
    int addSearchedBranch(int one, int two) {
        int branch = nextSearched++;
        child[2 * branch] = one;
        child[2 * branch + 1] = two;
        merge(branch);
        return branch;
    }

    /** Makes searches include such a node besides the tree, until the tree changes. */
    void searchAlso(int node) {
        top = root == NONE ? node : addSearchedBranch(root, node);
    }

    /** Makes searches use the tree alone. */
    void forgetSearched() {
        top = NONE;
    }

    boolean isLeaf(int node) {
        return child[2 * node] == NONE;
    }

    int carried(int leaf) {
        return child[2 * leaf + 1];
    }

    int first(int branch) {
        return child[2 * branch];
    }

    int second(int branch) {
        return child[2 * branch + 1];
    }

    /** Min x, min y, max x and max y of all nodes, m; read only. */
    double[] boxes() {
        return box;
    }

    private int take() {
        int node = slots.take();
        makeRoom(node + 1);
        return node;
    }

    private void makeRoom(int nodes) {
        if (nodes > parent.length) {
            int capacity = Math.max(nodes, Growth.after(parent.length));
            parent = Arrays.copyOf(parent, capacity);
            child = Arrays.copyOf(child, 2 * capacity);
            box = Arrays.copyOf(box, 4 * capacity);
        }
    }

    private void setLeaf(int leaf, int carried) {
        child[2 * leaf] = NONE;
        child[2 * leaf + 1] = carried;
    }

    /** The lowest branch, from one upwards, whose box holds that of a leaf; otherwise the root. */
    private int holderOf(int leaf, int from) {
        int holder = from == NONE ? root : from;
        while (holder != root && !holds(holder, leaf)) {
            holder = parent[holder];
        }
        return holder;
    }

    private boolean holds(int branch, int leaf) {
        int at = 4 * branch;
        int of = 4 * leaf;
        return box[at] <= box[of]
                && box[at + 1] <= box[of + 1]
                && box[at + 2] >= box[of + 2]
                && box[at + 3] >= box[of + 3];
    }

    private void attach(int leaf, int under) {
        top = NONE;
        if (root == NONE) {
            root = leaf;
            parent[leaf] = NONE;
            return;
        }
        int sibling = bestSibling(leaf, under);
        int branch = take();
        int above = parent[sibling];
        parent[branch] = above;
        child[2 * branch] = sibling;
        child[2 * branch + 1] = leaf;
        parent[sibling] = branch;
        parent[leaf] = branch;
        replaceChild(above, sibling, branch);
        merge(branch);
        growUp(above);
    }

    private void detach(int leaf) {
        top = NONE;
        if (leaf == root) {
            root = NONE;
            return;
        }
        int branch = parent[leaf];
        int sibling = child[2 * branch] == leaf ? child[2 * branch + 1] : child[2 * branch];
        int above = parent[branch];
        parent[sibling] = above;
        replaceChild(above, branch, sibling);
        slots.giveBack(branch);
        for (int node = above; node != NONE && merge(node); node = parent[node]) {
            // Above a box that did not change, no box changes.
        }
    }

    private void replaceChild(int above, int old, int fresh) {
        if (above == NONE) {
            root = fresh;
        } else if (child[2 * above] == old) {
            child[2 * above] = fresh;
        } else {
            child[2 * above + 1] = fresh;
        }
    }

    /**
     * Finds the place that costs least: the perimeter of the new branch there, plus what it adds to
     * all branches above. The search follows the cheaper side first, and the other one as long as
     * it may cost less than the best place so far (branch and bound: J. Bittner, M. Hapala and V.
     * Havran, Fast Insertion-Based Optimization of Bounding Volume Hierarchies, 2013). Following
     * one side alone would make a chain of boxes added from left to right over a wide floor.
     */
    private int bestSibling(int leaf, int under) {
        double own = perimeter(leaf);
        int best = under;
        double least = mergedPerimeter(under, leaf);
        int depth = put(0, under, least - perimeter(under));
        for (int looked = 0; depth > 0 && looked < MOST_LOOKED; looked++) {
            int node = places[--depth];
            double inherited = added[depth];
            if (inherited + own >= least || child[2 * node] == NONE) {
                continue;
            }
            int one = child[2 * node];
            int two = child[2 * node + 1];
            double mergedOne = mergedPerimeter(one, leaf);
            double mergedTwo = mergedPerimeter(two, leaf);
            if (inherited + mergedOne < least) {
                least = inherited + mergedOne;
                best = one;
            }
            if (inherited + mergedTwo < least) {
                least = inherited + mergedTwo;
                best = two;
            }
            double addedOne = mergedOne - perimeter(one);
            double addedTwo = mergedTwo - perimeter(two);
            boolean isOneFirst =
                    addedOne < addedTwo || addedOne == addedTwo && mergedOne <= mergedTwo;
            int last = isOneFirst ? two : one;
            double lastAdded = inherited + (isOneFirst ? addedTwo : addedOne);
            if (lastAdded + own < least) {
                depth = put(depth, last, lastAdded);
            }
            int next = isOneFirst ? one : two;
            depth = put(depth, next, inherited + (isOneFirst ? addedOne : addedTwo));
        }
        return best;
    }

    private int put(int depth, int node, double inherited) {
        if (depth == places.length) {
            places = Arrays.copyOf(places, 2 * depth);
            added = Arrays.copyOf(added, 2 * depth);
        }
        places[depth] = node;
        added[depth] = inherited;
        return depth + 1;
    }

    private void growUp(int from) {
        int node = from;
        boolean isChanged = true;
        while (node != NONE && isChanged) {
            isChanged = rotate(node) | merge(node);
            node = parent[node];
        }
    }

    /**
     * Exchanges a child with a grandchild of the other side where that shrinks a branch most;
     * returns whether it did.
     */
    private boolean rotate(int node) {
        int one = child[2 * node];
        int two = child[2 * node + 1];
        double gainOne = gain(one, two);
        double gainTwo = gain(two, one);
        if (gainOne <= 0 && gainTwo <= 0) {
            return false;
        }
        if (gainOne >= gainTwo) {
            exchange(node, one, two);
        } else {
            exchange(node, two, one);
        }
        return true;
    }

    /** The most by which a branch shrinks when another node replaces one of its children. */
    private double gain(int branch, int lowered) {
        int first = child[2 * branch];
        return first == NONE
                ? 0
                : perimeter(branch)
                        - Math.min(
                                mergedPerimeter(first, lowered),
                                mergedPerimeter(child[2 * branch + 1], lowered));
    }

    private void exchange(int node, int branch, int lowered) {
        int first = child[2 * branch];
        int second = child[2 * branch + 1];
        boolean raisesFirst = mergedPerimeter(second, lowered) <= mergedPerimeter(first, lowered);
        int raised = raisesFirst ? first : second;
        replaceChild(node, lowered, raised);
        replaceChild(branch, raised, lowered);
        parent[raised] = node;
        parent[lowered] = branch;
        merge(branch);
    }

    /** Recomputes a branch's box from its children's; returns whether it changed. */
    private boolean merge(int node) {
        int at = 4 * node;
        int one = 4 * child[2 * node];
        int two = 4 * child[2 * node + 1];
        double minX = Math.min(box[one], box[two]);
        double minY = Math.min(box[one + 1], box[two + 1]);
        double maxX = Math.max(box[one + 2], box[two + 2]);
        double maxY = Math.max(box[one + 3], box[two + 3]);
        boolean isSame =
                minX == box[at]
                        && minY == box[at + 1]
                        && maxX == box[at + 2]
                        && maxY == box[at + 3];
        setBox(node, minX, minY, maxX, maxY);
        return !isSame;
    }

    private void setBox(int node, double minX, double minY, double maxX, double maxY) {
        int at = 4 * node;
        box[at] = minX;
        box[at + 1] = minY;
        box[at + 2] = maxX;
        box[at + 3] = maxY;
    }

    /** Half the perimeter, m. */
    private double perimeter(int node) {
        int at = 4 * node;
        return box[at + 2] - box[at] + box[at + 3] - box[at + 1];
    }

    private double mergedPerimeter(int node, int other) {
        int n = 4 * node;
        int m = 4 * other;
        return Math.max(box[n + 2], box[m + 2])
                - Math.min(box[n], box[m])
                + Math.max(box[n + 3], box[m + 3])
                - Math.min(box[n + 1], box[m + 1]);
    }
}
