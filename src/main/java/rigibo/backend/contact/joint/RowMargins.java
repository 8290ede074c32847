package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

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
    private final GroupVelocities velocities;

    /** By row: the blocks of velocities that it acts on. */
    private int[] blockA = new int[64];

    private int[] blockB = new int[64];

    /** By row: its {@link #steepest}, 0 if it is not computed yet. */
    private double[] steepness = new double[64];

    /** By row: the sum of changes up to which it may be skipped; 0 if it may not. */
    private double[] until = new double[64];

    RowMargins(NeutralRows rows, GroupVelocities velocities) {
        this.rows = rows;
        this.velocities = velocities;
    }

    /** Begins with rows that were just written, whose groups of bodies have begun. */
    void list() {
        if (until.length < rows.count) {
            until = new double[rows.bodies.length];
            steepness = new double[rows.bodies.length];
            blockA = new int[rows.bodies.length];
            blockB = new int[rows.bodies.length];
        }
        Arrays.fill(steepness, 0, rows.count, 0);
        for (int row = 0; row < rows.count; row++) {
            int first = row * NeutralRows.BODIES;
            int last = first + rows.bodies[row] - 1;
            blockA[row] = last < first ? velocities.noBlock() : velocities.block(rows.body[first]);
            blockB[row] = last <= first ? velocities.noBlock() : velocities.block(rows.body[last]);
        }
    }

    /** Begins with velocities that were just taken; no row may be skipped yet. */
    void begin() {
        Arrays.fill(until, 0, rows.count, 0);
    }

    /** Whether a row may be skipped. */
    boolean isIdle(int row) {
        return moved(row) < until[row];
    }

    /** Lets no pass skip a row next time, since its impulse has changed. */
    void forget(int row) {
        until[row] = 0;
    }

    /** Takes note of a row's residual, m/s or rad/s. */
    void note(int row, double residual) {
        if (isLeaving(row, residual)) {
            double margin = SAFE * Math.abs(residual) / steepest(row);
            until[row] = moved(row) + margin;
        } else {
            until[row] = 0;
        }
    }

    private boolean isLeaving(int row, double residual) {
        boolean isLow = rows.impulse[row] == rows.lower[row] && residual > 0;
        return isLow || rows.impulse[row] == rows.upper[row] && residual < 0;
    }

    /**
     * The sum of the largest changes of velocities in both blocks of a row since they were taken,
     * m/s. A row's speed has changed by no more than this, times its {@link #steepest}.
     */
    private double moved(int row) {
        double[] moved = velocities.moved;
        return moved[blockA[row]] + moved[blockB[row]];
    }

    /**
     * Largest change of a row's speed if both of its bodies change theirs by 1 m/s, also at their
     * outlines by turning; infinite for rows of more than two bodies.
     */
    double steepest(int row) {
        if (steepness[row] == 0) {
            steepness[row] = steepness(row);
        }
        return steepness[row];
    }

    private double steepness(int row) {
        double most = rows.bodies[row] > 2 ? Double.POSITIVE_INFINITY : 0;
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.DERIVATIVES + 3 * k;
            int v = velocities.placeOf(rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE);
            double moves = Math.abs(rows.derivative[at]) + Math.abs(rows.derivative[at + 1]);
            double turns = Math.abs(rows.derivative[at + 2]) / velocities.reachAt(v);
            most = Math.max(most, moves + turns);
        }
        return most;
    }
}
