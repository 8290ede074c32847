package rigibo.backend.broadphase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Allocation;
import rigibo.backend.storage.Found;

import java.util.Arrays;
import java.util.Random;

/** Results of the grid, compared with a search of all boxes. */
class FixtureGridTest {

    private static final int BOXES = 500;

    private final FixtureGrid grid = new FixtureGrid();
    private final Found found = new Found();

    /** Boxes by number; null where the grid does not hold it. */
    private final double[][] boxes = new double[BOXES][];

    /**
     * Near the origin and far out, where doubles are 2 nm apart, with equal and with unequal sizes.
     */
    @ParameterizedTest
    @CsvSource({"1, 0, 2", "2, 0, 1e6", "3, 1e7, 2", "4, -1e7, 1e6", "5, 1e15, 10"})
    void findsWhatBruteForceFinds(long seed, double middle, double largest) {
        Random random = new Random(seed);
        for (int change = 0; change < 5000; change++) {
            int number = random.nextInt(BOXES);
            if (boxes[number] != null && random.nextInt(10) == 0) {
                grid.remove(number);
                boxes[number] = null;
            } else {
                double[] b = anyBox(random, middle, largest);
                if (grid.put(number, b[0], b[1], b[2], b[3])) {
                    boxes[number] = b;
                }
            }
            if (change % 5 == 0) {
                double[] q = anyBox(random, middle, largest);
                assertThat(query(q)).as("change " + change).containsExactly(overlapping(q));
            }
        }
        assertThat(grid.count())
                .isEqualTo((int) Arrays.stream(boxes).filter(b -> b != null).count());
    }

    /**
     * A box with a size from the largest down to its inverse; each power of ten is equally likely.
     */
    private static double[] anyBox(Random random, double middle, double largest) {
        double x = middle + 200 * (random.nextDouble() - 0.5);
        double y = 200 * (random.nextDouble() - 0.5);
        double width = Math.pow(largest, 2 * random.nextDouble() - 1);
        return new double[] {x, y, x + width, y + width * random.nextDouble()};
    }

    private int[] query(double[] q) {
        found.clear();
        grid.query(q[0], q[1], q[2], q[3], found);
        found.sort();
        found.dropRepeated();
        return Arrays.copyOf(found.numbers, found.count);
    }

    private int[] overlapping(double[] q) {
        Found all = new Found();
        for (int i = 0; i < BOXES; i++) {
            double[] b = boxes[i];
            if (b != null && b[0] <= q[2] && q[0] <= b[2] && b[1] <= q[3] && q[1] <= b[3]) {
                all.add(i);
            }
        }
        return Arrays.copyOf(all.numbers, all.count);
    }

    @Test
    void boxesThatOnlyTouchAreFound() {
        boxes[7] = new double[] {0, 0, 1, 1};
        grid.put(7, 0, 0, 1, 1);

        assertThat(query(new double[] {1, 1, 2, 2})).containsExactly(7);
        assertThat(query(new double[] {-1, -1, 0, 0})).containsExactly(7);
        assertThat(query(new double[] {1.001, 0, 2, 1})).isEmpty();
    }

    @Test
    void aBoxFromHereToFarOutFindsAll() {
        for (int i = 0; i < 100; i++) {
            grid.put(i, 3 * i, i, 3 * i + 1, i + 1);
        }

        double infinity = Double.POSITIVE_INFINITY;
        assertThat(query(new double[] {-1e300, -1e300, 1e300, 1e300})).hasSize(100);
        assertThat(query(new double[] {-infinity, -infinity, infinity, infinity})).hasSize(100);
        assertThat(query(new double[] {1e300, 0, 1e301, 1})).isEmpty();
    }

    @Test
    void whatNoCellIsFitForIsRefused() {
        assertThat(grid.put(0, 1, 1, 1, 1)).as("a point").isFalse();
        assertThat(grid.put(0, 0, 0, 1e12, 1)).as("larger than any cell").isFalse();
        assertThat(grid.put(0, 1e20, 0, 1.0000001e20, 1)).as("larger, far out").isFalse();
        assertThat(grid.put(0, 1e12, 0, 1e12 + 2e-4, 1e-4)).as("tiny, far out").isFalse();
        assertThat(grid.put(0, 0, 0, Double.NaN, 1)).as("no box").isFalse();
        assertThat(grid.count()).isZero();
    }

    /**
     * Ten thousand boxes of similar size, one for each 6.25 m². Those examined begin within a cell
     * (4 m), the box itself and the widest one (2.7 m) along each axis: at most 9.4² / 6.25 on
     * average.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e7})
    void looksAtAFewBoxesOnly(double middle) {
        Random random = new Random(8);
        for (int i = 0; i < 10_000; i++) {
            double x = middle + 250 * random.nextDouble();
            double y = 250 * random.nextDouble();
            double width = 2.05 + 0.65 * random.nextDouble();
            grid.put(i, x, y, x + width, y + width);
        }
        for (int i = 0; i < 10_000; i++) {
            found.clear();
            double x = middle + 250 * random.nextDouble();
            double y = 250 * random.nextDouble();
            grid.query(x, y, x + 2.7, y + 2.7, found);
        }
        assertThat(grid.looked() / 10_000.0).isLessThan(9.4 * 9.4 / 6.25);
    }

    /**
     * Boxes of twenty sizes, each twice as large as the one before, with as many of each per its
     * own area. A query of the smallest examines a few cells of each size, not all boxes in the
     * large cells.
     */
    @Test
    void looksAtFewOfManySizes() {
        Random random = new Random(9);
        int number = 0;
        for (int size = 0; size < 20; size++) {
            double width = Math.scalb(0.75, size);
            for (int i = 0; i < 400; i++) {
                double x = 20 * width * random.nextDouble();
                double y = 20 * width * random.nextDouble();
                grid.put(number++, x, y, x + width, y + width);
            }
        }
        for (int i = 0; i < 1000; i++) {
            found.clear();
            double x = 10 * random.nextDouble();
            double y = 10 * random.nextDouble();
            grid.query(x, y, x + 0.75, y + 0.75, found);
        }
        // 56 in the cells themselves, and one each of other cells in the 82 entries of the table.
        assertThat(grid.looked() / 1000.0).isLessThan(1.5 * (56 + 82));
    }

    @Test
    void nothingIsAllocatedOnceWarm() {
        Random random = new Random(6);
        for (int i = 0; i < BOXES; i++) {
            boxes[i] = anyBox(random, 0, 2);
        }
        assertThat(Allocation.ofThirdRun(this::shuffle)).isZero();
    }

    private void shuffle() {
        for (int round = 0; round < 300; round++) {
            for (int i = 0; i < BOXES; i++) {
                double[] b = boxes[(i + round) % BOXES];
                grid.put(i, b[0], b[1], b[2], b[3]);
                found.clear();
                grid.query(b[0], b[1], b[2], b[3], found);
            }
        }
    }
}
