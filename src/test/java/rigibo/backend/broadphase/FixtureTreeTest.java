package rigibo.backend.broadphase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Allocation;
import rigibo.backend.storage.Found;

import java.util.Arrays;
import java.util.Random;
import java.util.function.Predicate;

/** Results of the tree, compared with a search of all boxes. */
class FixtureTreeTest {

    private static final int BOXES = 600;

    private final FixtureTree tree = new FixtureTree();
    private final FixtureSearch search = new FixtureSearch(tree);
    private final Found found = new Found();

    /** Boxes by number; null where removed. Their leaves are in a list of their own. */
    private final double[][] boxes = new double[BOXES][];

    private final int[] leaves = new int[BOXES];

    @Test
    void emptyTreeHoldsNothing() {
        query(-1e9, -1e9, 1e9, 1e9);
        walk(-1e9, -1e9, 1e9, 1e9);

        assertThat(found.count).isZero();
    }

    @Test
    void boxesThatOnlyTouchAreFound() {
        tree.insert(7, 0, 0, 1, 1);

        query(1, 1, 2, 2);

        assertThat(numbers()).containsExactly(7);
    }

    @Test
    void theLastBoxCanBeRemovedAndAnotherAdded() {
        tree.remove(tree.insert(1, 0, 0, 1, 1));
        tree.insert(2, 0, 0, 1, 1);

        query(0, 0, 1, 1);

        assertThat(numbers()).containsExactly(2);
    }

    /**
     * A row on a floor and between walls that span all of it, in any order, and as it moves along.
     * No leaf is deeper than four times log₂ of their number; a chain would be half as deep as
     * there are boxes. Beside the floor and the walls a box adds no perimeter, so following the
     * cheaper side alone makes a chain.
     */
    @ParameterizedTest
    @ValueSource(strings = {"left to right", "right to left", "at random"})
    void aRowOnAWideFloorIsNoChain(String order) {
        int count = 4_096;
        int[] leaf = new int[count];
        Random random = new Random(5);
        tree.insert(count, -10, -1, 2 * count, 0);
        tree.insert(count + 1, -10, -1, -9, 50);
        for (int i = 0; i < count; i++) {
            int place =
                    switch (order) {
                        case "left to right" -> i;
                        case "right to left" -> count - 1 - i;
                        default -> random.nextInt(count);
                    };
            leaf[i] = tree.insert(i, 2 * place, 0, 2 * place + 1, 1);
        }
        assertThat(deepest(tree.root())).isLessThanOrEqualTo(4 * 12);
        for (int step = 1; step < 50; step++) {
            for (int i = 0; i < count; i++) {
                double left = 2 * i + 0.7 * step;
                tree.move(leaf[i], left, 0, left + 1, 1);
            }
        }
        assertThat(deepest(tree.root())).isLessThanOrEqualTo(4 * 12);
    }

    /** Sum of half the perimeters of all branches; the cost of a query is proportional to it. */
    private static double perimeter(FixtureTree of, int node) {
        if (of.isLeaf(node)) {
            return 0;
        }
        double[] box = of.boxes();
        double own = box[4 * node + 2] - box[4 * node] + box[4 * node + 3] - box[4 * node + 1];
        return own + perimeter(of, of.first(node)) + perimeter(of, of.second(node));
    }

    private int deepest(int node) {
        return tree.isLeaf(node)
                ? 0
                : 1 + Math.max(deepest(tree.first(node)), deepest(tree.second(node)));
    }

    /**
     * Each of a row of unit boxes grows by one to the right, and is found at its old and new
     * places.
     */
    @Test
    void whatGrewIsFoundInAllOfItsBox() {
        int[] leaf = new int[100];
        for (int i = 0; i < leaf.length; i++) {
            leaf[i] = tree.insert(i, 10 * i, 0, 10 * i + 1, 1);
        }
        for (int i = 0; i < leaf.length; i++) {
            tree.move(leaf[i], 10 * i, -1, 10 * i + 2, 1);
        }
        for (int i = 0; i < leaf.length; i++) {
            found.clear();
            query(10 * i + 1.5, -0.5, 10 * i + 1.5, -0.5);
            assertThat(numbers()).containsExactly(i);
            found.clear();
            query(10 * i + 0.5, 0.5, 10 * i + 0.5, 0.5);
            assertThat(numbers()).containsExactly(i);
        }
    }

    @Test
    void boxesInOnePlaceAreAllFound() {
        for (int i = 0; i < 100; i++) {
            tree.insert(i, 3, 3, 4, 4);
        }

        query(3.5, 3.5, 3.5, 3.5);

        assertThat(numbers()).hasSize(100).doesNotHaveDuplicates();
    }

    /** A line past the corner of a box lies within the box's bounds, but does not cross it. */
    @Test
    void lineThatPassesACornerDoesNotCross() {
        tree.insert(1, 0, 0, 1, 1);

        walk(0.5, 1.6, 1.6, 0.5);
        assertThat(found.count).isZero();
        walk(0.5, 1.4, 1.4, 0.5);
        assertThat(numbers()).containsExactly(1);
    }

    @Test
    void lineThatEndsBeforeABoxDoesNotCross() {
        tree.insert(1, 2, -1, 3, 1);

        walk(0, 0, 1.9, 0);
        assertThat(found.count).isZero();
        walk(0, 0, 2, 0);
        assertThat(numbers()).containsExactly(1);
    }

    /** After thousands of insertions, removals, short and long moves. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void findsWhatBruteForceFinds(long seed) {
        Random random = new Random(seed);
        for (int change = 0; change < 6000; change++) {
            change(random);
            if (change % 10 == 0) {
                compare(anyBox(random), "seed " + seed + ", change " + change);
            }
        }
    }

    private void change(Random random) {
        int number = random.nextInt(BOXES);
        if (boxes[number] == null) {
            boxes[number] = anyBox(random);
            double[] b = boxes[number];
            leaves[number] = tree.insert(number, b[0], b[1], b[2], b[3]);
        } else if (random.nextInt(10) == 0) {
            tree.remove(leaves[number]);
            boxes[number] = null;
        } else {
            double[] b = random.nextInt(10) == 0 ? anyBox(random) : nudged(random, boxes[number]);
            boxes[number] = b;
            tree.move(leaves[number], b[0], b[1], b[2], b[3]);
        }
    }

    /** Most boxes are small, some are as wide as a floor. */
    private static double[] anyBox(Random random) {
        double x = random.nextDouble() * 100;
        double y = random.nextDouble() * 100;
        double width = random.nextInt(20) == 0 ? 80 : random.nextDouble() * 4;
        return new double[] {x, y, x + width, y + random.nextDouble() * 4};
    }

    private static double[] nudged(Random random, double[] box) {
        double dx = random.nextDouble() - 0.5;
        double dy = random.nextDouble() - 0.5;
        return new double[] {box[0] + dx, box[1] + dy, box[2] + dx, box[3] + dy};
    }

    private void compare(double[] q, String where) {
        query(q[0], q[1], q[2], q[3]);
        assertThat(numbers()).as(where).containsExactly(overlapping(q));
        walk(q[0], q[3], q[2], q[1]);
        assertThat(numbers()).as("line, " + where).containsExactly(crossing(q));
    }

    private int[] overlapping(double[] q) {
        return numbersOf(b -> b[0] <= q[2] && q[0] <= b[2] && b[1] <= q[3] && q[1] <= b[3]);
    }

    /** The segment falls from the upper left to the lower right corner, clipped slab by slab. */
    private int[] crossing(double[] q) {
        double dx = q[2] - q[0];
        double dy = q[1] - q[3];
        return numbersOf(
                b -> {
                    double in = Math.max((b[0] - q[0]) / dx, (b[3] - q[3]) / dy);
                    double out = Math.min((b[2] - q[0]) / dx, (b[1] - q[3]) / dy);
                    return Math.max(in, 0) <= Math.min(out, 1);
                });
    }

    private int[] numbersOf(Predicate<double[]> isFound) {
        int[] all = new int[BOXES];
        int count = 0;
        for (int i = 0; i < BOXES; i++) {
            if (boxes[i] != null && isFound.test(boxes[i])) {
                all[count++] = i;
            }
        }
        return Arrays.copyOf(all, count);
    }

    /** Adds all fixtures that share a point with a box to the result. */
    private void query(double minX, double minY, double maxX, double maxY) {
        Found there = search.query(minX, minY, maxX, maxY);
        for (int i = 0; i < there.count; i++) {
            found.add(there.numbers[i]);
        }
    }

    /** Adds all fixtures that a ray meets to the result. */
    private void walk(double fromX, double fromY, double toX, double toY) {
        RayWalk walk = new RayWalk(tree);
        walk.begin(fromX, fromY, toX, toY);
        for (int number = walk.next(1); number != RayWalk.END; number = walk.next(1)) {
            found.add(number);
        }
    }

    /** Returns the numbers found, ascending, and empties the list. */
    private int[] numbers() {
        found.sort();
        int[] numbers = Arrays.copyOf(found.numbers, found.count);
        found.clear();
        return numbers;
    }

    /**
     * Boxes drift and mix for 300 steps. The cost of queries grows with the perimeter of the
     * branches; a tree that kept its first shape would have many times that of one built at the
     * end.
     */
    @Test
    void theTreeDoesNotDecayWhileBoxesMix() {
        Random random = new Random(5);
        double[][] way = new double[BOXES][];
        for (int i = 0; i < BOXES; i++) {
            double[] b = anyBox(random);
            boxes[i] = new double[] {b[0], b[1], b[0] + 1, b[1] + 1};
            leaves[i] = tree.insert(i, b[0], b[1], b[0] + 1, b[1] + 1);
            way[i] = new double[] {random.nextDouble(), random.nextDouble()};
        }
        for (int step = 0; step < 300; step++) {
            for (int i = 0; i < BOXES; i++) {
                drift(boxes[i], way[i]);
                tree.move(leaves[i], boxes[i][0], boxes[i][1], boxes[i][2], boxes[i][3]);
            }
        }
        FixtureTree fresh = new FixtureTree();
        for (int i = 0; i < BOXES; i++) {
            fresh.insert(i, boxes[i][0], boxes[i][1], boxes[i][2], boxes[i][3]);
        }
        assertThat(perimeter(tree, tree.root())).isLessThan(1.25 * perimeter(fresh, fresh.root()));
    }

    /** Moves a box within a square of 100 m and reflects it at the sides. */
    private static void drift(double[] box, double[] way) {
        for (int axis = 0; axis < 2; axis++) {
            if (box[axis] + way[axis] < 0 || box[axis] + way[axis] > 100) {
                way[axis] = -way[axis];
            }
            box[axis] += way[axis];
            box[axis + 2] += way[axis];
        }
    }

    @Test
    void nothingIsAllocatedOnceWarm() {
        Random random = new Random(6);
        for (int i = 0; i < BOXES; i++) {
            boxes[i] = anyBox(random);
            leaves[i] = tree.insert(i, boxes[i][0], boxes[i][1], boxes[i][2], boxes[i][3]);
        }
        assertThat(Allocation.ofThirdRun(() -> shuffle(300))).isZero();
    }

    private void shuffle(int rounds) {
        for (int round = 0; round < rounds; round++) {
            for (int i = 0; i < BOXES; i++) {
                double[] b = boxes[(i + round) % BOXES];
                tree.move(leaves[i], b[0], b[1], b[2], b[3]);
                search.query(b[0], b[1], b[2], b[3]);
            }
        }
    }
}
