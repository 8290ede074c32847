package rigibo.backend.algebra;

import java.util.Arrays;

/**
 * A square matrix, factored as L·U row by row (Doolittle) without pivoting. Row i of L and column i
 * of U begin at the first nonzero entry of either, which is their envelope; nothing before it is
 * stored or computed. For a stack, whose rows couple only with their neighbours, the envelope is a
 * band. Where row and column are equal, U = D·Lᵀ takes half the work.
 */
public final class EnvelopeFactor {

    /** Rows for which there is room at first. */
    private static final int ROWS = 64;

    /** Entries for which there is room at first. */
    private static final int ENTRIES = 512;

    /** By row: the first column of its envelope. The caller writes it before {@link #lay}. */
    public int[] first = new int[ROWS];

    private int size;

    /** Index at which each row starts. */
    private int[] start = new int[ROWS + 1];

    /** L by rows and U by columns, each from its first entry to the diagonal. */
    private double[] lower = new double[ENTRIES];

    private double[] upper = new double[ENTRIES];

    /** Reciprocals of the diagonal of U. */
    private double[] inverse = new double[ROWS];

    private double work;

    /** Makes room for a number of rows and keeps the present ones. */
    public void reserve(int rows) {
        if (first.length < rows) {
            first = Arrays.copyOf(first, rows);
            start = Arrays.copyOf(start, rows + 1);
            inverse = Arrays.copyOf(inverse, rows);
        }
    }

    /**
     * Lays out the envelope of a number of rows. Rows before the first one that differs stay
     * factored.
     *
     * @param rows number of rows
     */
    public void lay(int rows) {
        size = rows;
        int length = 0;
        for (int i = 0; i < rows; i++) {
            start[i] = length;
            length += i - first[i] + 1;
        }
        start[rows] = length;
        if (lower.length < length) {
            lower = Arrays.copyOf(lower, 2 * length);
            upper = Arrays.copyOf(upper, 2 * length);
        }
    }

    /** Clears row i and column i. */
    public void clear(int i) {
        Arrays.fill(lower, start[i], start[i + 1], 0);
        Arrays.fill(upper, start[i], start[i + 1], 0);
    }

    /** Writes the entry in row i and column j ≤ i. */
    public void writeLower(int i, int j, double entry) {
        lower[start[i] - first[i] + j] = entry;
    }

    /**
     * Writes the entry in row j and column i, j &lt; i, if it differs from that in row i and column
     * j.
     */
    public void writeUpper(int i, int j, double entry) {
        upper[start[i] - first[i] + j] = entry;
    }

    /**
     * Computes row i of L and column i of U from those before them.
     *
     * @param i number of the row and column
     * @param isSymmetric whether all columns up to this one equal their rows
     * @param least replaces a diagonal entry that elimination leaves smaller than this
     */
    public void eliminate(int i, boolean isSymmetric, double least) {
        int own = start[i] - first[i];
        for (int j = first[i]; j < i; j++) {
            int from = Math.max(first[i], first[j]);
            int mine = own + from;
            int other = start[j] - first[j] + from;
            double l = lower[own + j] - dot(lower, mine, upper, other, j - from);
            double u = l;
            if (!isSymmetric) {
                u = upper[own + j] - dot(upper, mine, lower, other, j - from);
                work += j - from;
            }
            lower[own + j] = l * inverse[j];
            upper[own + j] = u;
            work += j - from + 1;
        }
        double left = lower[own + i] - dot(lower, start[i], upper, start[i], i - first[i]);
        inverse[i] = 1 / (Math.abs(left) > least ? left : least);
        work += i - first[i];
    }

    /** Dot product of parts of two arrays, in four sums that do not wait for each other. */
    private static double dot(double[] a, int atA, double[] b, int atB, int length) {
        double sum0 = 0;
        double sum1 = 0;
        double sum2 = 0;
        double sum3 = 0;
        int k = 0;
        for (; k < length - 3; k += 4) {
            sum0 += a[atA + k] * b[atB + k];
            sum1 += a[atA + k + 1] * b[atB + k + 1];
            sum2 += a[atA + k + 2] * b[atB + k + 2];
            sum3 += a[atA + k + 3] * b[atB + k + 3];
        }
        for (; k < length; k++) {
            sum0 += a[atA + k] * b[atB + k];
        }
        return sum0 + sum1 + (sum2 + sum3);
    }

    /** Solves for a right-hand side in place, by forward and backward substitution. */
    public void solve(double[] unknown) {
        for (int i = 0; i < size; i++) {
            unknown[i] -= dot(lower, start[i], unknown, first[i], i - first[i]);
        }
        for (int i = size - 1; i >= 0; i--) {
            double x = unknown[i] * inverse[i];
            unknown[i] = x;
            int column = start[i] - first[i];
            for (int k = first[i]; k < i; k++) {
                unknown[k] -= upper[column + k] * x;
            }
        }
    }

    /** Multiplications for factoring since the count was cleared. */
    public double work() {
        return work;
    }

    public void clearWork() {
        work = 0;
    }
}
