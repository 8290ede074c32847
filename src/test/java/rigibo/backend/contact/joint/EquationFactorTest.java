package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.Motions;

import java.util.SplittableRandom;

/** Elimination along an assembly tree against Gauss's elimination of the whole matrix. */
class EquationFactorTest {

    /** Round-off of some hundred operations on matrices whose condition is below 1e6. */
    private static final double ROUND_OFF = 1e-8;

    private final Motions motions = new Motions(true);
    private final NeutralRows rows = new NeutralRows(motions, null);

    private void addBodies(int count, SplittableRandom random) {
        motions.data = new double[(count + 1) * Motions.STRIDE];
        motions.slots = new int[count + 1];
        motions.count = count + 1;
        for (int entry = 1; entry <= count; entry++) {
            int at = entry * Motions.STRIDE;
            motions.data[at + Motions.INVERSE_MASS] = random.nextDouble(0.5, 2);
            motions.data[at + Motions.INVERSE_INERTIA] = random.nextDouble(0.5, 8);
        }
    }

    /** A hinge: two equations, between two bodies or a body and the ground, 0. */
    private void hinge(int a, int b, SplittableRandom random) {
        double armA = random.nextDouble(-1, 1);
        double armB = random.nextDouble(-1, 1);
        for (int axis = 0; axis < 2; axis++) {
            int row = rows.add();
            double x = 1 - axis;
            double y = axis;
            rows.derive(row, a * Motions.STRIDE, -x, -y, axis == 0 ? armB : -armA);
            rows.derive(row, b * Motions.STRIDE, x, y, axis == 0 ? -armA : armB);
            rows.finish(row);
        }
    }

    /** K·x = asked by Gauss's elimination with pivots, K written out row by row. */
    private double[] dense(double[] asked) {
        int n = rows.count;
        double[][] k = new double[n][n + 1];
        for (int i = 0; i < n; i++) {
            rows.apply(i, 1);
            for (int j = 0; j < n; j++) {
                k[j][i] = rows.speed(j);
            }
            rows.apply(i, -1);
            k[i][i] += rows.give[i] + NeutralRows.REGULAR * rows.response[i];
            k[i][n] = asked[i];
        }
        for (int p = 0; p < n; p++) {
            int best = p;
            for (int i = p; i < n; i++) {
                best = Math.abs(k[i][p]) > Math.abs(k[best][p]) ? i : best;
            }
            double[] swapped = k[p];
            k[p] = k[best];
            k[best] = swapped;
            for (int i = 0; i < n; i++) {
                double factor = i == p ? 0 : k[i][p] / k[p][p];
                for (int j = p; j <= n && factor != 0; j++) {
                    k[i][j] -= factor * k[p][j];
                }
            }
        }
        double[] x = new double[n];
        for (int i = 0; i < n; i++) {
            x[i] = k[i][n] / k[i][i];
        }
        return x;
    }

    private void isSolved(SplittableRandom random) {
        EquationFactor factor = new EquationFactor(motions, rows);
        factor.layOut();
        isSolved(factor, random);
    }

    private void isSolved(EquationFactor factor, SplittableRandom random) {
        double[] asked = new double[rows.count];
        factor.changeAll();
        for (int i = 0; i < rows.count; i++) {
            asked[i] = random.nextDouble(-1, 1);
            rows.give[i] = 1e-3;
        }
        factor.changeAll();
        for (int e = 0; e < rows.count; e++) {
            factor.ask(e, asked[factor.equations().row[e]]);
        }
        solve(factor);
        double[] truth = dense(asked);
        for (int e = 0; e < rows.count; e++) {
            double scale = 1 + Math.abs(truth[factor.equations().row[e]]);
            assertThat(factor.answer(e) / scale)
                    .isCloseTo(truth[factor.equations().row[e]] / scale, within(ROUND_OFF));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void chainsAreSolvedAsAWhole(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        addBodies(30, random);
        for (int link = 1; link <= 30; link++) {
            hinge(link - 1, link, random);
        }
        isSolved(random);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {4, 5, 6})
    void treesAreSolvedAsAWhole(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        addBodies(40, random);
        for (int body = 2; body <= 40; body++) {
            hinge(random.nextInt(1, body), body, random);
        }
        isSolved(random);
    }

    /** With loops, and in two groups that nothing joins. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {7, 8, 9})
    void netsAreSolvedAsAWhole(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int side = 5;
        addBodies(2 * side * side, random);
        for (int net = 0; net < 2; net++) {
            for (int i = 0; i < side * side; i++) {
                int body = net * side * side + i + 1;
                if (i % side > 0) {
                    hinge(body - 1, body, random);
                }
                if (i >= side) {
                    hinge(body - side, body, random);
                }
            }
        }
        isSolved(random);
    }

    /**
     * The hub has more equations than one copy takes, so that it is solved as several welded
     * copies.
     */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {10, 11, 12})
    void hubsAreSolvedAsAWhole(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        addBodies(2 * EquationList.MOST_OF_COPY, random);
        for (int body = 2; body <= 2 * EquationList.MOST_OF_COPY; body++) {
            hinge(1, body, random);
        }
        hinge(0, 1, random);
        isSolved(random);
    }

    /** The hub has as many equations as arrays have room for without the welds of its copies. */
    @ParameterizedTest(name = "{0} hinges")
    @ValueSource(ints = {13, 16, 28, 31, 32, 60, 64})
    void hubsOfAsManyEquationsAsThereIsRoomForAreSolvedAsAWhole(int hinges) {
        SplittableRandom random = new SplittableRandom(hinges);
        addBodies(hinges, random);
        hinge(0, 1, random);
        for (int body = 2; body <= hinges; body++) {
            hinge(1, body, random);
        }
        isSolved(random);
    }

    /**
     * Contacts come and go between two lists of the same equations, so that arrays grow. A factor
     * that has listed the equations before must solve as one that lists them first.
     */
    @ParameterizedTest(name = "{0} links")
    @ValueSource(ints = {4, 6, 8, 10, 12, 15})
    void equationsAreSolvedAlikeAfterMoreRowsOfOtherKinds(int links) {
        SplittableRandom random = new SplittableRandom(links);
        addBodies(links, random);
        for (int link = 1; link <= links; link++) {
            hinge(link - 1, link, random);
        }
        int equations = rows.count;
        EquationFactor factor = new EquationFactor(motions, rows);
        factor.layOut();
        for (int room = rows.bodies.length; rows.bodies.length < 8 * room; ) {
            int grown = 2 * rows.bodies.length;
            while (rows.bodies.length < grown) {
                int other = rows.add();
                rows.load[other] = 0;
            }
            factor.layOut();
            rows.count = equations;
            isSolved(factor, random);
        }
    }

    private static void solve(EquationFactor factor) {
        for (int group = 0; group < factor.tree().groups; group++) {
            factor.solve(group);
        }
    }

    /** Twice the joints on one body take at most 2.2 times the work and the room. */
    @ParameterizedTest(name = "{0} joints")
    @ValueSource(ints = {200, 800})
    void hubsTakeWorkAndRoomThatGrowWithTheirJoints(int joints) {
        EquationFactor one = factorOfHub(joints);
        EquationFactor two = factorOfHub(2 * joints);
        assertThat(two.takeWork()).isLessThan(2.2 * one.takeWork());
        assertThat((double) two.tree().room).isLessThan(2.2 * one.tree().room);
    }

    private EquationFactor factorOfHub(int joints) {
        SplittableRandom random = new SplittableRandom(joints);
        rows.clear();
        addBodies(joints + 1, random);
        for (int body = 2; body <= joints + 1; body++) {
            hinge(1, body, random);
        }
        EquationFactor factor = new EquationFactor(motions, rows);
        factor.layOut();
        factor.changeAll();
        solve(factor);
        return factor;
    }

    /**
     * The work of a chain of n links grows with n: twice the links take at most 2.2 times the work.
     */
    @ParameterizedTest(name = "{0} links")
    @ValueSource(ints = {64, 256})
    void chainsTakeWorkThatGrowsWithTheirLinks(int links) {
        double one = workOfChain(links);
        double two = workOfChain(2 * links);
        assertThat(two).isLessThan(2.2 * one);
    }

    private double workOfChain(int links) {
        SplittableRandom random = new SplittableRandom(links);
        rows.clear();
        addBodies(links, random);
        for (int link = 1; link <= links; link++) {
            hinge(link - 1, link, random);
        }
        EquationFactor factor = new EquationFactor(motions, rows);
        factor.layOut();
        factor.changeAll();
        solve(factor);
        return factor.takeWork();
    }
}
