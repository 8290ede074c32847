package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;

import java.util.SplittableRandom;

/** Random rows with bounds on so few bodies that rows contradict each other. */
class RowDescentTest {

    private static final int BODIES = 6;
    private static final int ROWS = 24;

    /** Round-off of some hundred pushes of at most 10 m/s. */
    private static final double SOLVED = 1e-11;

    private final Motions motions = new Motions(true);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final RowElimination elimination = new RowElimination(motions, rows);
    private final RowDescent descent = new RowDescent(rows, elimination);
    private final int[] bounded = new int[ROWS];
    private final int[] side = new int[ROWS];

    private void island(SplittableRandom random) {
        motions.data = new double[(BODIES + 1) * Motions.STRIDE];
        motions.slots = new int[BODIES + 1];
        motions.reach = new double[BODIES + 1];
        motions.count = BODIES + 1;
        for (int entry = 1; entry <= BODIES; entry++) {
            int at = entry * Motions.STRIDE;
            motions.data[at + Motions.INVERSE_MASS] = random.nextDouble(0.1, 2);
            motions.data[at + Motions.INVERSE_INERTIA] = random.nextDouble(0.1, 8);
            for (int column = Motions.VX; column <= Motions.SPIN; column++) {
                motions.data[at + column] = random.nextDouble(-1, 1);
            }
        }
        rows.clear();
        for (int i = 0; i < ROWS; i++) {
            add(random, i);
        }
        elimination.beginIsland(1e9);
        elimination.begin();
        for (int row = 0; row < ROWS; row++) {
            boolean isIn = random.nextBoolean();
            elimination.put(row, isIn);
            side[row] = -1;
            bounded[row] = row;
            if (!isIn) {
                rows.push(row, rows.lower[row]);
            }
        }
    }

    /** A row that only pushes, or one between two bounds. */
    private void add(SplittableRandom random, int i) {
        int row = rows.add();
        for (int body : random.ints(1, BODIES + 1).distinct().limit(1 + i % 2).toArray()) {
            rows.derive(
                    row,
                    body * Motions.STRIDE,
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1),
                    random.nextDouble(-1, 1));
        }
        boolean isOfContact = i % 3 > 0;
        rows.lower[row] = isOfContact ? 0 : -random.nextDouble(0.01, 0.2);
        rows.upper[row] = isOfContact ? Double.POSITIVE_INFINITY : -rows.lower[row];
        rows.give[row] = 1e-3;
        rows.target[row] = random.nextDouble(-1, 1);
        rows.finish(row);
    }

    /**
     * Rows within their bounds get the speed that they ask for, and rows at a bound are not driven
     * beyond it: w ≥ 0 at the lower one, w ≤ 0 at the upper one. Exchanging all wrong rows at once
     * does not end with these numbers of rows and bodies.
     */
    @Test
    void rowsAreSolvedWithinTheirBounds() {
        SplittableRandom random = new SplittableRandom(3);
        int within = 0;
        int atBounds = 0;
        for (int i = 0; i < 500; i++) {
            island(random);
            assertThat(descent.solve(bounded, ROWS, side, SOLVED)).as("draw %d", i).isTrue();
            for (int row = 0; row < ROWS; row++) {
                double residual = rows.residual(row);
                double impulse = rows.impulse[row];
                assertThat(impulse).isBetween(rows.lower[row], rows.upper[row]);
                if (impulse > rows.lower[row] && impulse < rows.upper[row]) {
                    within++;
                    assertThat(Math.abs(residual)).as("draw %d", i).isLessThan(SOLVED);
                } else {
                    atBounds++;
                    double beyond = impulse == rows.lower[row] ? -residual : residual;
                    assertThat(beyond).as("draw %d", i).isLessThan(SOLVED);
                }
            }
        }
        assertThat(within).isGreaterThan(1_000);
        assertThat(atBounds).isGreaterThan(1_000);
    }

    /** A spent budget of multiplications ends the descent. */
    @Test
    void endsWhereItsBudgetDoes() {
        island(new SplittableRandom(3));
        elimination.beginIsland(0);
        elimination.count(1);
        assertThat(descent.solve(bounded, ROWS, side, SOLVED)).isFalse();
    }
}
