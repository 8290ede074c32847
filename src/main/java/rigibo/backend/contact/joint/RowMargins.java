package rigibo.backend.contact.joint;

import java.util.Arrays;

/**
 * Rows that no pass needs to ask: those at a bound that their bodies leave. Such a row keeps its
 * impulse until the velocities of its bodies have changed by what would bring it back. Most
 * contacts and limits of a heap are open, so that passes read few of its rows.
 */
final class RowMargins {

    /** Leaves room for the round-off of sums of many changes. */
    private static final double SAFE = 1 - 1e-6;

    private final NeutralRows rows;
    private final Responses responses;

    /** By row: up to which sum of changes it need not be asked; 0 for none. */
    private double[] until = new double[64];

    RowMargins(NeutralRows rows, Responses responses) {
        this.rows = rows;
        this.responses = responses;
    }

    /** Begins with rows none of which has been asked since velocities were taken. */
    void begin() {
        if (until.length < rows.count) {
            until = new double[rows.bodies.length];
        }
        Arrays.fill(until, 0, rows.count, 0);
    }

    /** Whether a row is at a bound that its bodies still leave. */
    boolean isIdle(int row) {
        return responses.moved(row) < until[row];
    }

    /** Has a row asked next time, since its impulse is another one. */
    void forget(int row) {
        until[row] = 0;
    }

    /** Notes what a row is from what it asks for, m/s or rad/s. */
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
