package rigibo.backend.contact.joint;

import java.util.Arrays;

/**
 * Finds rows that passes may skip: those at a bound whose bodies move away from it. Such a row
 * keeps its impulse until the velocities of its bodies have changed enough to bring it back. Most
 * contacts and limits of a heap are open, so that passes read few of its rows.
 */
final class RowMargins {

    /** Leaves room for the round-off of sums of many changes. */
    private static final double SAFE = 1 - 1e-6;

    private final NeutralRows rows;
    private final Responses responses;

    /** By row: the sum of changes up to which it may be skipped; 0 if it may not. */
    private double[] until = new double[64];

    RowMargins(NeutralRows rows, Responses responses) {
        this.rows = rows;
        this.responses = responses;
    }

    /** Begins with velocities that were just taken; no row may be skipped yet. */
    void begin() {
        if (until.length < rows.count) {
            until = new double[rows.bodies.length];
        }
        Arrays.fill(until, 0, rows.count, 0);
    }

    /** Whether a row may be skipped. */
    boolean isIdle(int row) {
        return responses.moved(row) < until[row];
    }

    /** Lets no pass skip a row next time, since its impulse has changed. */
    void forget(int row) {
        until[row] = 0;
    }

    /** Takes note of a row's residual, m/s or rad/s. */
    void note(int row, double residual) {
        if (isLeaving(row, residual)) {
            double margin = SAFE * Math.abs(residual) / responses.steepest(row);
            until[row] = responses.moved(row) + margin;
        } else {
            until[row] = 0;
        }
    }

    private boolean isLeaving(int row, double residual) {
        boolean isLow = rows.impulse[row] == rows.lower[row] && residual > 0;
        return isLow || rows.impulse[row] == rows.upper[row] && residual < 0;
    }
}
