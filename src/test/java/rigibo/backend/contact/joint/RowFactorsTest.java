package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.Motions;

import java.util.SplittableRandom;

/** Rows of two to four bodies at random: both factors and passes against a dense matrix. */
class RowFactorsTest {

    /** Round-off of some hundred operations on matrices whose condition is below 1e6. */
    private static final double ROUND_OFF = 1e-8;

    private static final int BODIES = 12;

    private final Motions motions = new Motions(true);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final RowElimination elimination = new RowElimination(motions, rows);

    private void island(SplittableRandom random, int count) {
        motions.data = new double[(BODIES + 1) * Motions.STRIDE];
        motions.slots = new int[BODIES + 1];
        motions.reach = new double[BODIES + 1];
        motions.count = BODIES + 1;
        for (int entry = 1; entry <= BODIES; entry++) {
            int at = entry * Motions.STRIDE;
            motions.data[at + Motions.INVERSE_MASS] = random.nextDouble(0.5, 2);
            motions.data[at + Motions.INVERSE_INERTIA] = random.nextDouble(0.5, 8);
            for (int column = Motions.VX; column <= Motions.SPIN; column++) {
                motions.data[at + column] = random.nextDouble(-1, 1);
            }
        }
        rows.clear();
        for (int i = 0; i < count; i++) {
            int row = rows.add();
            int own = 1 + random.nextInt(NeutralRows.BODIES);
            int[] of = random.ints(1, BODIES + 1).distinct().limit(own).toArray();
            for (int body : of) {
                rows.derive(
                        row,
                        body * Motions.STRIDE,
                        random.nextDouble(-1, 1),
                        random.nextDouble(-1, 1),
                        random.nextDouble(-1, 1));
            }
            rows.give[row] = random.nextDouble(0.01, 0.2);
            rows.target[row] = random.nextDouble(-1, 1);
            rows.finish(row);
        }
        elimination.beginIsland(1e9);
        elimination.begin();
    }

    /** Derivatives of a row over all bodies. */
    private double[] dense(double[] derivative, int row) {
        double[] all = new double[3 * motions.count];
        for (int k = 0; k < rows.bodies[row]; k++) {
            int to = 3 * (rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE);
            for (int i = 0; i < 3; i++) {
                all[to + i] += derivative[row * NeutralRows.DERIVATIVES + 3 * k + i];
            }
        }
        return all;
    }

    /** J·M⁻¹·Pᵀ of two rows. */
    private double response(double[] measured, int row, double[] pushed, int other) {
        double[] j = dense(measured, row);
        double[] p = dense(pushed, other);
        double sum = 0;
        for (int i = 3; i < j.length; i++) {
            int mass = i % 3 == 2 ? Motions.INVERSE_INERTIA : Motions.INVERSE_MASS;
            sum += j[i] * motions.data[i / 3 * Motions.STRIDE + mass] * p[i];
        }
        return sum;
    }

    private void take(SplittableRandom random) {
        for (int row = 0; row < rows.count; row++) {
            elimination.put(row, random.nextInt(4) > 0);
        }
    }

    /** Applying the answers changes rows of the set by what was asked, and no other impulse. */
    private void assertSolved(double[] asked) {
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            assertThat(elimination.isIn(row)).isTrue();
            assertThat(elimination.numberOf(row)).isEqualTo(i);
            double sum = rows.give[row] * elimination.answer(i);
            double scale = 1;
            for (int k = 0; k < elimination.size(); k++) {
                double term = response(rows.derivative, row, rows.derivative, elimination.row(k));
                sum += term * elimination.answer(k);
                scale += Math.abs(term * elimination.answer(k));
            }
            assertThat(sum).isCloseTo(asked[row], within(ROUND_OFF * scale));
        }
    }

    /** Successive sets keep the part of the factor that they share. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void setsAreSolvedAsAWhole(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 30; i++) {
            island(random, 5 + random.nextInt(90));
            for (int set = 0; set < 4; set++) {
                take(random);
                double[] asked = random.doubles(rows.count, -1, 1).toArray();
                elimination.solveFor(asked);
                assertSolved(asked);
            }
        }
    }

    /** A row that leaves at the end costs next to nothing; nothing changed costs nothing. */
    @Test
    void onlyWhatChangedIsFactoredAnew() {
        SplittableRandom random = new SplittableRandom(4);
        island(random, 60);
        for (int row = 0; row < rows.count; row++) {
            elimination.put(row, true);
        }
        elimination.factorize();
        double all = elimination.work();
        assertThat(all).isPositive().isLessThanOrEqualTo(elimination.workOfAll());
        island(random, 60);
        for (int row = 0; row < rows.count; row++) {
            elimination.put(row, true);
        }
        elimination.factorize();
        double before = elimination.work();
        elimination.factorize();
        assertThat(elimination.work()).isEqualTo(before);
        elimination.put(elimination.row(elimination.size() - 1), false);
        elimination.factorize();
        assertThat(elimination.work() - before).isLessThan(before / 10);
        double[] asked = random.doubles(rows.count, -1, 1).toArray();
        elimination.solveFor(asked);
        assertSolved(asked);
        elimination.forget();
        before = elimination.work();
        elimination.factorize();
        assertThat(elimination.work()).isGreaterThan(before);
    }

    @Test
    void workIsCountedAgainstItsBudget() {
        elimination.beginIsland(10);
        elimination.count(10);
        assertThat(elimination.isSpent()).isFalse();
        elimination.count(1);
        assertThat(elimination.isSpent()).isTrue();
        assertThat(elimination.work()).isEqualTo(11);
        elimination.beginIsland(10);
        assertThat(elimination.work()).isZero();
    }

    /** N = J·M⁻¹·Pᵀ of impulses that act along other derivatives than the rows'. */
    @ParameterizedTest
    @ValueSource(longs = {5, 6})
    void impulsesMayActAlongOthers(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        UnsymmetricElimination unsymmetric = new UnsymmetricElimination(motions, rows, elimination);
        for (int i = 0; i < 30; i++) {
            island(random, 3 + random.nextInt(60));
            take(random);
            double[] pushed = nearby(random);
            unsymmetric.factorize(pushed);
            assertUnsymmetric(random, unsymmetric, rows.derivative, pushed);
        }
    }

    /** Places are measured by the derivatives at the drift's end, speeds by those at its start. */
    @Test
    void placesAreMeasuredAhead() {
        SplittableRandom random = new SplittableRandom(7);
        UnsymmetricElimination unsymmetric = new UnsymmetricElimination(motions, rows, elimination);
        for (int i = 0; i < 30; i++) {
            island(random, 3 + random.nextInt(20));
            take(random);
            NeutralRows ahead = new NeutralRows(motions, null);
            ahead.derivative = nearby(random);
            double[] measured = rows.derivative.clone();
            for (int row = 0; row < rows.count; row++) {
                rows.holdsPlace[row] = random.nextBoolean();
                if (rows.holdsPlace[row]) {
                    int at = row * NeutralRows.DERIVATIVES;
                    System.arraycopy(ahead.derivative, at, measured, at, NeutralRows.DERIVATIVES);
                }
            }
            unsymmetric.factorize(ahead);
            assertUnsymmetric(random, unsymmetric, measured, rows.derivative);
        }
    }

    private double[] nearby(SplittableRandom random) {
        double[] other = rows.derivative.clone();
        for (int i = 0; i < other.length; i++) {
            other[i] += random.nextDouble(-0.05, 0.05);
        }
        return other;
    }

    private void assertUnsymmetric(
            SplittableRandom random,
            UnsymmetricElimination unsymmetric,
            double[] measured,
            double[] pushed) {
        double[] asked = random.doubles(rows.count, -1, 1).toArray();
        unsymmetric.solve(asked);
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            double sum = rows.give[row] * unsymmetric.answer(i);
            double scale = 1;
            for (int k = 0; k < elimination.size(); k++) {
                double term = response(measured, row, pushed, elimination.row(k));
                sum += term * unsymmetric.answer(k);
                scale += Math.abs(term * unsymmetric.answer(k));
            }
            // Pivots are not exchanged, which loses a few more digits.
            assertThat(sum).isCloseTo(asked[row], within(1e-5 * scale));
        }
    }

    /** Passes end where each row has its target or is at a bound that it would be driven beyond. */
    @Test
    void passesEndAtTheLawOfBounds() {
        SplittableRandom random = new SplittableRandom(8);
        RowPasses passes = new RowPasses(rows);
        for (int i = 0; i < 30; i++) {
            island(random, 10);
            for (int row = 0; row < rows.count; row++) {
                rows.lower[row] = row % 2 == 0 ? 0 : -0.1;
                rows.upper[row] = row % 2 == 0 ? Double.POSITIVE_INFINITY : 0.1;
            }
            // The last one is bounded by a share of the load of the first two.
            int last = rows.count - 1;
            rows.load[last] = 0;
            rows.loads[last] = 1;
            rows.share[last] = 0.3;
            passes.begin();
            passes.run(100_000, 1e-14);
            assertThat(passes.solves()).isPositive();
            for (int row = 0; row < rows.count; row++) {
                double residual = rows.residual(row);
                double impulse = rows.impulse[row];
                double lower = row == last ? -0.3 * rows.impulse[0] : rows.lower[row];
                double upper = row == last ? 0.3 * rows.impulse[0] : rows.upper[row];
                assertThat(impulse).isBetween(lower - ROUND_OFF, upper + ROUND_OFF);
                boolean isMet = Math.abs(residual) < ROUND_OFF;
                boolean isLow = impulse < lower + ROUND_OFF && residual > 0;
                boolean isHigh = impulse > upper - ROUND_OFF && residual < 0;
                assertThat(isMet || isLow || isHigh).isTrue();
            }
        }
    }

    @Test
    void passesEndEarlyAndAreCounted() {
        island(new SplittableRandom(9), 10);
        RowPasses passes = new RowPasses(rows);
        passes.begin();
        passes.run(3, 0);
        assertThat(passes.solves()).isEqualTo(30);
        passes.run(1_000, Double.MAX_VALUE);
        assertThat(passes.solves()).isEqualTo(40);
        passes.begin();
        assertThat(passes.solves()).isZero();
    }

    /** Impulses of a pair of rows beyond their disc are shortened to its edge. */
    @Test
    void pairsStayWithinADisc() {
        motions.data = new double[2 * Motions.STRIDE];
        motions.reach = new double[2];
        motions.count = 2;
        motions.data[Motions.STRIDE + Motions.INVERSE_MASS] = 1;
        motions.data[Motions.STRIDE + Motions.VX] = -3;
        motions.data[Motions.STRIDE + Motions.VY] = -4;
        rows.clear();
        int x = rows.add();
        int y = rows.add();
        rows.derive(x, Motions.STRIDE, 1, 0, 0);
        rows.derive(y, Motions.STRIDE, 0, 1, 0);
        rows.finish(x);
        rows.finish(y);
        rows.twin[x] = y;
        rows.twin[y] = x;
        rows.share[x] = 2;
        rows.share[y] = 2;
        rows.bound();
        assertThat(rows.upper[x]).isCloseTo(1.2, within(1e-12));
        assertThat(rows.lower[y]).isCloseTo(-1.6, within(1e-12));
        rows.share[x] = 6;
        rows.bound(x);
        assertThat(rows.upper[x]).isCloseTo(6, within(1e-12));
    }

    /** Which rows are equations, which are lengths, and how far their bodies reach. */
    @Test
    void rowsTellWhatTheyAre() {
        island(new SplittableRandom(10), 40);
        for (int row = 0; row < rows.count; row++) {
            assertThat(rows.isEquation(row)).isTrue();
            assertThat(rows.response[row])
                    .isCloseTo(response(rows.derivative, row, rows.derivative, row), within(1e-12));
            double speed = 0;
            double[] j = dense(rows.derivative, row);
            for (int i = 3; i < j.length; i++) {
                speed += j[i] * motions.data[i / 3 * Motions.STRIDE + i % 3];
            }
            assertThat(rows.speed(row)).isCloseTo(speed, within(1e-12));
            assertThat(rows.unit[row]).isEqualTo(1);
        }
        rows.lower[0] = 0;
        rows.upper[1] = 1;
        rows.load[2] = 0;
        rows.twin[3] = 2;
        for (int row = 0; row < 4; row++) {
            assertThat(rows.isEquation(row)).isFalse();
        }
        motions.reach[1] = 2;
        motions.reach[2] = 3;
        motions.reach[3] = Double.POSITIVE_INFINITY;
        int turns = rows.add();
        for (int body = 1; body <= 3; body++) {
            rows.derive(turns, body * Motions.STRIDE, 0, 0, 1);
        }
        rows.derive(turns, 0, 0, 0, 1);
        assertThat(rows.bodies[turns]).isEqualTo(3);
        rows.finish(turns);
        assertThat(rows.unit[turns]).isEqualTo(3);
        assertThat(rows.inMetres(turns, -0.5)).isEqualTo(1.5);
        motions.data[2 * Motions.STRIDE + Motions.INVERSE_INERTIA] = 0;
        assertThat(rows.reach(turns)).isEqualTo(2);
    }

    /** Pushing a row to its wish solves it alone. */
    @Test
    void whatARowWishesSolvesIt() {
        island(new SplittableRandom(11), 20);
        for (int row = 0; row < rows.count; row++) {
            rows.push(row, rows.wish(row) - rows.impulse[row]);
            assertThat(rows.residual(row)).isCloseTo(0, within(1e-12));
        }
    }
}
