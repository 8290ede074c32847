package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.contact.solve.ContactSweep;

/**
 * Solves islands of many joints and contacts. Their equations are eliminated all at once, which
 * takes little along an {@link AssemblyTree}; contacts, limits and motors are passed over, and
 * after each pass the equations hold again. So joints are exact at any load, and only what has
 * bounds is as near as passes bring it.
 */
final class CrowdSolver {

    /** Passes in a substep at most; the next one begins with what they came to. */
    private static final int MOST_PASSES = 24;

    /** Share of the fastest speed below which a change does not count. */
    private static final double QUIET = 0.03;

    /** How many times its tolerance of an impact a contact may miss its bounds in a substep. */
    private static final double MISSED_CONTACT = 3;

    /** Newton's steps to where equations hold at the end of a drift. */
    private static final int MOST_STEPS = 3;

    /** How far a place may be missed, as a share of the joint's arms and of the tolerance. */
    private static final double MISSED_PLACE = 1e-2;

    /** Energy that Newton's steps may add, as a share of that of motion. */
    private static final double GAINED = 1e-4;

    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final Poses poses;
    private final PackedJoints packed;
    private final EquationFactor factor;
    private final ContactSweep sweep;
    private final double tolerance;
    private final double missed;

    /** Rows with bounds, and rows that give the same whatever happens. */
    private int[] bounded = new int[64];

    private int boundedCount;

    /** Velocities before a kick's impulses, and before the equations hold, as the motions. */
    private double[] free = new double[64];

    private double[] before = new double[64];

    /** By row: its speed before impulses, m/s. */
    private double[] freeSpeed = new double[64];

    private double freeEnergy;

    /** Rows solved since it was asked for last. */
    private long solves;

    CrowdSolver(
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            JointRows jointRows,
            Poses poses,
            PackedJoints packed,
            ContactSweep sweep,
            double tolerance) {
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.jointRows = jointRows;
        this.poses = poses;
        this.packed = packed;
        this.sweep = sweep;
        this.tolerance = tolerance;
        double root = Math.sqrt(tolerance);
        missed = MISSED_CONTACT * root * Math.sqrt(root);
        factor = new EquationFactor(motions, rows);
    }

    /** How many numbers the factor of the rows takes as they are now. */
    double workOfAll() {
        return factor.workOfAll();
    }

    /** Multiplications made since it was asked for last. */
    double takeWork() {
        return factor.takeWork();
    }

    /** Rows solved since it was asked for last. */
    long takeSolves() {
        long sum = solves;
        solves = 0;
        return sum;
    }

    /** Begins with rows that were just written for a part of h seconds. */
    void begin(double h) {
        if (freeSpeed.length < rows.count) {
            freeSpeed = new double[rows.bodies.length];
            bounded = new int[rows.bodies.length];
        }
        boundedCount = 0;
        for (int row = 0; row < rows.count; row++) {
            if (!rows.isEquation(row)) {
                bounded[boundedCount++] = row;
            }
        }
        factor.factorize();
        correct(h);
    }

    /** Notes how bodies move after a kick and before any impulse. */
    void takeFree() {
        int length = motions.count * Motions.STRIDE;
        if (free.length < length) {
            free = new double[motions.data.length];
            before = new double[motions.data.length];
        }
        System.arraycopy(motions.data, 0, free, 0, length);
        freeEnergy = motions.energy(motions.data);
        for (int row = 0; row < rows.count; row++) {
            if (!rows.holdsPlace[row]) {
                freeSpeed[row] = rows.speed(row);
            }
        }
    }

    /**
     * Solves for a substep of h seconds whose kick lasts so many; contacts have given bodies what
     * they carried before. Joints give a share of what they carried in the kick before.
     *
     * @param noise energy that may be gained, J
     */
    void solve(double h, double kick, int substep, double fastest, double share, double noise) {
        warm(share);
        run(h, kick, substep, fastest);
        if (!motions.isAnyDriven && gained() > noise + GAINED * freeEnergy) {
            restart();
            run(h, kick, substep, fastest);
        }
    }

    private void warm(double share) {
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            double carried = packed.impulseOf(rows.joint[row], rows.part[row]);
            double wanted = within(row, share * carried);
            if (wanted != 0) {
                rows.push(row, wanted);
            }
        }
        holdEquations();
    }

    private double within(int row, double impulse) {
        double lower = rows.lower[row];
        double upper = rows.upper[row];
        return impulse > upper ? upper : impulse < lower ? lower : impulse;
    }

    /** Begins from nothing: what bodies had carried was too much. */
    private void restart() {
        System.arraycopy(free, 0, motions.data, 0, motions.count * Motions.STRIDE);
        for (int row = 0; row < rows.count; row++) {
            rows.impulse[row] = 0;
        }
        for (int contact = 0; contact < contacts.count; contact++) {
            int at = contact * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.IMPULSE0] = 0;
            contacts.data[at + PackedContacts.IMPULSE1] = 0;
            contacts.data[at + PackedContacts.IMPULSE_T] = 0;
            contacts.data[at + PackedContacts.IMPULSE_R] = 0;
        }
    }

    /** J that contacts and what joints hold have added: all but the work of springs and motors. */
    private double gained() {
        double sum = motions.energy(motions.data) - freeEnergy;
        for (int row = 0; row < rows.count; row++) {
            if (!rows.holdsPlace[row]) {
                sum -= rows.impulse[row] * (freeSpeed[row] + rows.speed(row)) / 2;
            }
        }
        return sum;
    }

    private void run(double h, double kick, int substep, double fastest) {
        double quiet = QUIET * fastest;
        sweep.begin(h, kick, substep, missed, quiet);
        boolean isAny = true;
        for (int pass = 0; pass < MOST_PASSES && isAny; pass++) {
            boolean isBack = pass % 2 == 1;
            int due = sweep.pass(isBack);
            double change = pass(isBack);
            hold();
            isAny = due > 0 || change > quiet;
        }
    }

    /** One pass over what has bounds; the largest change, m/s. */
    private double pass(boolean isBack) {
        double most = 0;
        solves += boundedCount;
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[isBack ? boundedCount - 1 - i : i];
            if (rows.twin[row] != NeutralRows.NONE) {
                rows.bound(row);
            }
            double wish = within(row, rows.wish(row));
            double change = wish - rows.impulse[row];
            if (change != 0) {
                rows.push(row, change);
                most = Math.max(most, Math.abs(change) * rows.response[row]);
            }
        }
        return most;
    }

    /** Brings all equations to what they ask for, and tells the sweep whom that moved. */
    private void hold() {
        System.arraycopy(motions.data, 0, before, 0, motions.count * Motions.STRIDE);
        holdEquations();
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            double change =
                    Math.abs(m[at + Motions.VX] - before[at + Motions.VX])
                            + Math.abs(m[at + Motions.VY] - before[at + Motions.VY])
                            + motions.reach[entry]
                                    * Math.abs(m[at + Motions.SPIN] - before[at + Motions.SPIN]);
            sweep.note(entry, change);
        }
    }

    private void holdEquations() {
        for (int e = 0; e < factor.count(); e++) {
            factor.ask(e, -rows.residual(factor.row(e)));
        }
        pushAnswers();
    }

    private void pushAnswers() {
        factor.solve();
        for (int e = 0; e < factor.count(); e++) {
            rows.push(factor.row(e), factor.answer(e));
        }
    }

    /** Holds the places of equations at the end of a drift of h seconds. */
    void holdPlaces(double h) {
        double energy = motions.energy(motions.data);
        int length = motions.count * Motions.STRIDE;
        System.arraycopy(motions.data, 0, before, 0, length);
        for (int i = 0; i < MOST_STEPS && ask(h) > 1; i++) {
            pushAnswers();
        }
        if (motions.energy(motions.data) > (1 + GAINED) * energy) {
            // Impulses are those of before but for what changes no body.
            System.arraycopy(before, 0, motions.data, 0, length);
        }
    }

    /** Asks for what places would be missed by; the most, as a multiple of what they may be. */
    private double ask(double h) {
        poses.take(h);
        jointRows.measureAnew();
        double worst = 0;
        for (int e = 0; e < factor.count(); e++) {
            int row = factor.row(e);
            if (rows.holdsPlace[row]) {
                double off = jointRows.place(row) - rows.place[row];
                factor.ask(e, -off / h);
                double most = MISSED_PLACE * tolerance * jointRows.size();
                worst = Math.max(worst, Math.abs(off) / most);
            } else {
                factor.ask(e, -rows.residual(row));
            }
        }
        return worst;
    }

    /**
     * Takes back what joints are off their places, by moving bodies, at the begin of a part of h
     * seconds: limits first, then equations, which hold in the end.
     */
    private void correct(double h) {
        double most = Recovery.MOST_PUSH * Math.abs(h);
        double seen = MISSED_PLACE * tolerance;
        for (int e = 0; e < factor.count(); e++) {
            factor.ask(e, rows.along(factor.row(e), Motions.DX));
        }
        boolean isAny = correctLimits(most, seen);
        for (int e = 0; e < factor.count(); e++) {
            int row = factor.row(e);
            double off = rows.holdsPlace[row] ? rows.place[row] : 0;
            isAny |= Math.abs(off) > seen;
            double moved = rows.along(row, Motions.DX) - factor.answer(e);
            factor.ask(e, -Math.max(-most, Math.min(most, off)) - moved);
        }
        if (isAny) {
            factor.solve();
            for (int e = 0; e < factor.count(); e++) {
                rows.move(factor.row(e), factor.answer(e), Motions.DX);
            }
        }
    }

    private boolean correctLimits(double most, double seen) {
        boolean isAny = false;
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            if (rows.holdsPlace[row] && rows.place[row] < -seen) {
                isAny = true;
                double off = Math.min(most, -rows.place[row]);
                rows.move(row, off / rows.response[row], Motions.DX);
            }
        }
        return isAny;
    }
}
