package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * Solves sliding rows together with their loads. A row whose bound follows from loads has the
 * impulse s·μ times their sum, where s is the side on which it is at its bound. So a load acts
 * along J + s·μ·T, with T the derivatives of the sliding row, and K + s·μ·J·M⁻¹·Tᵀ is not
 * symmetric. If bounds follow loads one round after the other instead, the rounds need not end
 * where friction changes the loads as much as they change it, as for a leaning rod.
 */
final class SlidingRows {

    private static final int NONE = NeutralRows.NONE;

    /** Most rows that slide by one load: a contact's friction and its rolling. */
    private static final int MOST = 2;

    private final NeutralRows rows;
    private final RowElimination elimination;
    private final UnsymmetricElimination unsymmetric;

    /** Derivatives along which impulses act, laid out as those of the rows. */
    private double[] pushed = new double[0];

    /** By row: the rows that slide by its load. */
    private int[] sliding = new int[0];

    /** By row outside the set: the bound that it is at, −1 or 1. */
    private int[] side;

    /** By row: the change of speed asked for, m/s. */
    private double[] asked = new double[0];

    SlidingRows(Motions motions, NeutralRows rows, RowElimination elimination) {
        this.rows = rows;
        this.elimination = elimination;
        unsymmetric = new UnsymmetricElimination(motions, rows, elimination);
    }

    /** Begins with the present set, and with the sides of rows outside it. */
    void begin(int[] sides) {
        side = sides;
        if (asked.length < rows.count) {
            asked = new double[rows.bodies.length];
            pushed = new double[rows.derivative.length];
            sliding = new int[rows.bodies.length * MOST];
        }
        System.arraycopy(rows.derivative, 0, pushed, 0, rows.count * NeutralRows.DERIVATIVES);
        Arrays.fill(sliding, 0, rows.count * MOST, NONE);
        bound();
        for (int row = 0; row < rows.count; row++) {
            if (slides(row)) {
                rows.push(row, side[row] * rows.upper[row] - rows.impulse[row]);
                for (int i = 0; i < rows.loads[row]; i++) {
                    add(row, rows.load[row] + i);
                }
            }
        }
        unsymmetric.factorize(pushed);
    }

    private boolean slides(int row) {
        return rows.load[row] != NONE && !elimination.isIn(row);
    }

    /** Updates the bounds that depend on loads. */
    void bound() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.load[row] != NONE) {
                rows.bound(row);
            }
        }
    }

    /** Adds a sliding row's derivatives to a load of the same two bodies. */
    private void add(int row, int load) {
        if (!elimination.isIn(load)) {
            return;
        }
        int at = load * MOST;
        sliding[sliding[at] == NONE ? at : at + 1] = row;
        double factor = side[row] * rows.share[row];
        int from = row * NeutralRows.DERIVATIVES;
        int to = load * NeutralRows.DERIVATIVES;
        for (int i = 0; i < 3 * rows.bodies[row]; i++) {
            pushed[to + i] += factor * rows.derivative[from + i];
        }
    }

    /** Asks for the residuals of the set's rows; returns the largest, m/s. */
    double ask() {
        double worst = 0;
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            double residual = rows.residual(row);
            asked[row] = -residual;
            worst = Math.max(worst, rows.inMetres(row, residual));
        }
        return worst;
    }

    /** Applies the solution to the set's rows, and to the rows that slide by them. */
    void push() {
        unsymmetric.solve(asked);
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            double change = unsymmetric.answer(i);
            rows.push(row, change);
            for (int k = row * MOST; k < (row + 1) * MOST && sliding[k] != NONE; k++) {
                rows.push(sliding[k], side[sliding[k]] * rows.share[sliding[k]] * change);
            }
        }
    }
}
