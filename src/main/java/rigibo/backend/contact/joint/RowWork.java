package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * Keeps contacts and what joints hold from adding energy: the work of an impulse j is j·(w₀ + w₁)/2
 * with the speeds along its row without any impulse and with all of them. Springs and motors may do
 * work; all other rows together may not.
 */
final class RowWork {

    /** Round-off of energies and of work, as a share of the energy of motion. */
    static final double ENERGY_ROUND_OFF = 1e-6;

    private final NeutralRows rows;
    private final NearRows near;

    /** By row: its speed without impulses, m/s. */
    private double[] before = new double[64];

    /** Velocities of all bodies without impulses, laid out as the motions. */
    private double[] free = new double[64];

    /** Energy of all bodies without impulses, J. */
    private double freeEnergy;

    private final Motions motions;

    RowWork(Motions motions, NeutralRows rows, NearRows near) {
        this.motions = motions;
        this.rows = rows;
        this.near = near;
    }

    /** Stores the velocities of bodies without impulses, and the speeds of rows. */
    void begin() {
        if (before.length < rows.count) {
            before = new double[rows.bodies.length];
        }
        applyAll(-1);
        keepFree();
        for (int row = 0; row < rows.count; row++) {
            before[row] = rows.speed(row);
        }
        applyAll(1);
    }

    /** Stores the velocities of bodies before any impulse of a row. */
    void keepFree() {
        int length = motions.count * Motions.STRIDE;
        if (free.length < length) {
            free = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, free, 0, length);
        freeEnergy = motions.energy(motions.data);
    }

    private void applyAll(double share) {
        for (int row = 0; row < rows.count; row++) {
            if (rows.impulse[row] != 0) {
                rows.apply(row, share * rows.impulse[row]);
            }
        }
    }

    /**
     * Work of contacts and of rows that hold places since {@link #begin}, J. They may do none,
     * except for taut joints at the speeds at which they close. A spring that presses against such
     * rows takes as much as they seem to do while a body is stopped between them; hence the work at
     * their present speeds counts if that is less.
     */
    double sum() {
        double sum = 0;
        double now = 0;
        for (int row = 0; row < rows.count; row++) {
            boolean mayDoNone = rows.holdsPlace[row] || rows.contact[row] != NeutralRows.NONE;
            if (rows.impulse[row] != 0 && mayDoNone) {
                double closing = ofClosing(row);
                sum += of(row) - closing;
                now += rows.impulse[row] * rows.speed(row) - closing;
            }
        }
        return Math.min(sum, now);
    }

    /**
     * Work of contacts at their present speeds, J: 0 if they are solved. Friction is measured
     * relative to its running surface, which may drive.
     */
    double sumOfContactsNow() {
        double sum = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.impulse[row] != 0 && rows.contact[row] != NeutralRows.NONE) {
                double driven = rows.isPoint(row) ? near.speedOf(row) : rows.target[row];
                sum += rows.impulse[row] * (rows.speed(row) - driven);
            }
        }
        return sum;
    }

    /** Work of brakes since {@link #begin}, J; it is at most 0 if they are solved. */
    double sumOfBrakes() {
        double sum = 0;
        for (int row = 0; row < rows.count; row++) {
            sum += rows.impulse[row] != 0 && rows.isBrake(row) ? of(row) : 0;
        }
        return sum;
    }

    /**
     * Whether bodies gained exactly the work of all rows. Huge intermediate impulses can leave some
     * of their round-off in velocities along which no row holds.
     */
    boolean isAllOfRows() {
        double sum = 0;
        for (int row = 0; row < rows.count; row++) {
            sum += rows.impulse[row] == 0 ? 0 : of(row);
        }
        double energy = motions.energy(motions.data);
        return Math.abs(energy - freeEnergy - sum) <= ENERGY_ROUND_OFF * (energy + freeEnergy);
    }

    /** Work of a taut joint at the speed that it aims at, J. */
    private double ofClosing(int row) {
        double impulse = rows.impulse[row];
        boolean isTaut = rows.isEquation(row) || rows.give[row] > 0;
        boolean mayClose = rows.holdsPlace[row] && isTaut;
        return mayClose ? impulse * (rows.target[row] - rows.give[row] * impulse) : 0;
    }

    private double of(int row) {
        return rows.impulse[row] * (before[row] + rows.speed(row)) / 2;
    }

    /**
     * Takes all impulses back. Velocities are restored from their copy, since some impulses may not
     * be finite.
     */
    void takeBack() {
        System.arraycopy(free, 0, motions.data, 0, motions.count * Motions.STRIDE);
        Arrays.fill(rows.impulse, 0, rows.count, 0);
    }

    /**
     * Sets the target speeds of contacts and of rows that hold places to at most 0, since others
     * could do work. Taut joints become rigid, since without a target their loads would move them.
     */
    void rest() {
        for (int row = 0; row < rows.count; row++) {
            if (rows.holdsPlace[row] || rows.contact[row] != NeutralRows.NONE) {
                rows.target[row] = Math.min(0, rows.target[row]);
                if (rows.isEquation(row)) {
                    rows.target[row] = 0;
                }
                if (rows.holdsPlace[row]) {
                    rows.give[row] = 0;
                }
            }
        }
    }
}
