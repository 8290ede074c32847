package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * N = J'·M⁻¹·Pᵀ of a set of rows whose impulses act along derivatives P, while the response is
 * measured by J'. It is factored as L·U within the envelope of the set, which both triangles share.
 *
 * <p>One such matrix is Newton's for the places at the end of a drift: J' are the derivatives
 * there, and P those at its start. Where a light body carries many times its weight, J·M⁻¹·Jᵀ is no
 * substitute: links that turn by a millionth would already make Newton's steps grow. Another is
 * that of sliding rows: each load acts together with the friction that it allows.
 */
final class UnsymmetricElimination {

    private static final int NONE = -1;

    private final Motions motions;
    private final NeutralRows rows;

    private final RowElimination elimination;

    /** Both triangles by rows of the lower one, the upper one transposed, and the diagonal of U. */
    private double[] lower = new double[1024];

    private double[] upper = new double[1024];
    private double[] pivot = new double[64];
    private double[] unknown = new double[64];

    /** By entry of the motions: the last derivative. By derivative: the one before it. */
    private int[] lastOf = new int[16];

    private int[] before = new int[256];

    /** J' of rows that hold places, and P, laid out as the derivatives of the rows. */
    private double[] measured;

    private double[] pushed;

    UnsymmetricElimination(Motions motions, NeutralRows rows, RowElimination elimination) {
        this.motions = motions;
        this.rows = rows;
        this.elimination = elimination;
    }

    /** Factors the set of the elimination, with the derivatives of places at a drift's end. */
    void factorize(NeutralRows ahead) {
        factorize(ahead.derivative, rows.derivative);
    }

    /** Factors the set of the elimination, whose impulses act along other derivatives. */
    void factorize(double[] actsAlong) {
        factorize(rows.derivative, actsAlong);
    }

    private void factorize(double[] measuredBy, double[] actsAlong) {
        measured = measuredBy;
        pushed = actsAlong;
        elimination.lay();
        reserve();
        Arrays.fill(lastOf, 0, motions.count, NONE);
        for (int i = 0; i < elimination.size(); i++) {
            assemble(i);
            eliminate(i);
        }
    }

    private void reserve() {
        int size = elimination.size();
        int length = size == 0 ? 0 : elimination.start[size - 1] + size;
        if (lower.length < length) {
            lower = new double[2 * length];
            upper = new double[2 * length];
        }
        if (pivot.length < size) {
            pivot = new double[rows.bodies.length];
            unknown = new double[rows.bodies.length];
        }
        if (before.length < rows.count * NeutralRows.BODIES) {
            before = new int[rows.bodies.length * NeutralRows.BODIES];
        }
        if (lastOf.length < motions.count) {
            lastOf = new int[motions.slots.length];
        }
    }

    private void assemble(int i) {
        int row = elimination.row(i);
        int first = elimination.first[i];
        int start = elimination.start[i];
        Arrays.fill(lower, start, start + i - first, 0);
        Arrays.fill(upper, start, start + i - first, 0);
        double own = 0;
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.BODIES + k;
            int entry = rows.body[at] / Motions.STRIDE;
            before[at] = lastOf[entry];
            lastOf[entry] = at;
            for (int other = at; other != NONE; other = before[other]) {
                int otherRow = other / NeutralRows.BODIES;
                int l = other % NeutralRows.BODIES;
                if (otherRow != row) {
                    int to = start + elimination.numberOf(otherRow) - first;
                    lower[to] += through(row, k, otherRow, l);
                    upper[to] += through(otherRow, l, row, k);
                } else {
                    own += through(row, k, row, l) + (l == k ? 0 : through(row, l, row, k));
                }
            }
        }
        pivot[i] = own + NeutralRows.REGULAR * rows.response[row] + rows.give[row];
    }

    /** What an impulse of one row gives the place of another through a body of both, 1/kg. */
    private double through(int row, int i, int from, int k) {
        double[] place = rows.holdsPlace[row] ? measured : rows.derivative;
        return rows.through(place, row, i, pushed, from, k);
    }

    private void eliminate(int i) {
        int first = elimination.first[i];
        int at = elimination.start[i] - first;
        for (int j = first; j < i; j++) {
            int from = Math.max(first, elimination.first[j]);
            int to = elimination.start[j] - elimination.first[j];
            elimination.count(2.0 * (j - from));
            double left = lower[at + j];
            double right = upper[at + j];
            for (int k = from; k < j; k++) {
                left -= lower[at + k] * upper[to + k];
                right -= lower[to + k] * upper[at + k];
            }
            lower[at + j] = left / pivot[j];
            upper[at + j] = right;
        }
        double left = pivot[i];
        for (int j = first; j < i; j++) {
            left -= lower[at + j] * upper[at + j];
        }
        pivot[i] = rows.pivot(elimination.row(i), left);
    }

    /**
     * Solves for the impulses of the set's rows that give changes of speed in m/s, stated by row;
     * {@link #answer} returns them.
     */
    void solve(double[] asked) {
        int size = elimination.size();
        for (int i = 0; i < size; i++) {
            int at = elimination.start[i] - elimination.first[i];
            double sum = asked[elimination.row(i)];
            for (int k = elimination.first[i]; k < i; k++) {
                sum -= lower[at + k] * unknown[k];
            }
            unknown[i] = sum;
        }
        for (int i = size - 1; i >= 0; i--) {
            int at = elimination.start[i] - elimination.first[i];
            unknown[i] /= pivot[i];
            for (int k = elimination.first[i]; k < i; k++) {
                unknown[k] -= upper[at + k] * unknown[i];
            }
        }
    }

    /** Impulse of a row of the set in the solution. */
    double answer(int i) {
        return unknown[i];
    }
}
