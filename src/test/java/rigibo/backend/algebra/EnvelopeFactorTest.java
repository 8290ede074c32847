package rigibo.backend.algebra;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

/** Solutions are put back into the matrix, whose diagonal dominates each row. */
class EnvelopeFactorTest {

    /** Digits that elimination of some tens of rows loses where no pivot is small. */
    private static final double ROUND_OFF = 1e-13;

    private static final double LEAST = 1e-3;

    private final EnvelopeFactor factor = new EnvelopeFactor();
    private final SplittableRandom random = new SplittableRandom(1);

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void solvesItsMatrix(boolean isSymmetric) {
        for (int size = 1; size <= 40; size++) {
            double[][] matrix = matrix(size, isSymmetric);
            factorize(matrix, 0, isSymmetric);
            assertSolves(matrix);
        }
    }

    /** Rows that come after the last that has stayed are all that is eliminated anew. */
    @Test
    void keepsTheRowsBeforeThoseThatChange() {
        double[][] matrix = matrix(20, false);
        factorize(matrix, 0, false);
        double all = factor.work();
        factor.clearWork();
        matrix[19][19] *= 2;
        factorize(matrix, 19, false);
        assertSolves(matrix);
        assertThat(factor.work()).isBetween(1.0, all / 2);
    }

    /** A row that is the copy of another leaves nothing on the diagonal. */
    @Test
    void takesTheLeastThatIsGivenForAPivotThatIsLost() {
        double[][] matrix = {{1, 1}, {1, 1}};
        factorize(matrix, 0, true);
        double[] unknown = {0, 0.5};
        factor.solve(unknown);
        assertThat(unknown[1]).isCloseTo(0.5 / LEAST, within(ROUND_OFF / LEAST));
        assertThat(unknown[0]).isCloseTo(-0.5 / LEAST, within(ROUND_OFF / LEAST));
    }

    private double[][] matrix(int size, boolean isSymmetric) {
        double[][] matrix = new double[size][size];
        factor.reserve(size);
        for (int i = 0; i < size; i++) {
            factor.first[i] = random.nextInt(i + 1);
            for (int j = factor.first[i]; j < i; j++) {
                matrix[i][j] = random.nextDouble(-1, 1);
                matrix[j][i] = isSymmetric ? matrix[i][j] : random.nextDouble(-1, 1);
            }
            matrix[i][i] = random.nextBoolean() ? size : -size;
        }
        return matrix;
    }

    private void factorize(double[][] matrix, int from, boolean isSymmetric) {
        factor.reserve(matrix.length);
        factor.lay(matrix.length);
        for (int i = from; i < matrix.length; i++) {
            factor.clear(i);
            for (int j = factor.first[i]; j < i; j++) {
                factor.writeLower(i, j, matrix[i][j]);
                factor.writeUpper(i, j, matrix[j][i]);
            }
            factor.writeLower(i, i, matrix[i][i]);
            factor.eliminate(i, isSymmetric, LEAST);
        }
    }

    private void assertSolves(double[][] matrix) {
        double[] asked = random.doubles(matrix.length, -1, 1).toArray();
        double[] found = asked.clone();
        factor.solve(found);
        for (int i = 0; i < matrix.length; i++) {
            double sum = 0;
            for (int j = 0; j < matrix.length; j++) {
                sum += matrix[i][j] * found[j];
            }
            assertThat(sum).isCloseTo(asked[i], within(ROUND_OFF));
        }
    }
}
