package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * What slides, solved with its loads: a row at a bound that follows from loads has s·μ times their
 * sum, where s is the side it is at, so that a load acts along (J + s·μ·T) with the derivatives T
 * of the row that slides. K + s·μ·J·M⁻¹·Tᵀ is not symmetric. Bounds that follow loads one round
 * after the other need not come to an end where what they rub by changes loads as much: a rod that
 * leans.
 */
final class SlidingRows {

    private static final int NONE = NeutralRows.NONE;

    /** Rows that slide by one load at most: a contact's friction and its rolling. */
    private static final int MOST = 2;

    private final NeutralRows rows;
    private final RowElimination elimination;
    private final UnsymmetricElimination unsymmetric;

    /** Along what the impulses of rows act, laid out as their derivatives. */
    private double[] pushed = new double[0];

    /** By row those that slide by its load. */
    private int[] sliding = new int[0];

    /** By row: at which bound it is while it is out of the set, −1 or 1. */
    private int[] side;

    /** By row: by how much its speed is to change, m/s. */
    private double[] asked = new double[0];

    SlidingRows(Motions motions, NeutralRows rows, RowElimination elimination) {
        this.rows = rows;
        this.elimination = elimination;
        unsymmetric = new UnsymmetricElimination(motions, rows, elimination);
    }

    /** Begins with the set as it is, and the sides of rows that are out of it. */
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

    /** Writes the bounds that follow loads as they are now. */
    void bound() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.load[row] != NONE) {
                rows.bound(row);
            }
        }
    }

    /** Lets what slides act with a load of the same two bodies. */
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

    /** Asks the set's rows for what they lack; the most, m/s. */
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

    /** Pushes the set's rows, and what slides by them, by what brings what was asked for. */
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
