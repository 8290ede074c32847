package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/**
 * Finds the impulses with which what joints hold is held at the end of a drift, where rows have
 * turned: Newton's method, with the matrix of the drift's start as long as that gains digits, else
 * with that of its end. Where contacts carry, too, they may be next to contradicting the joints;
 * then no more is asked than what does not make bodies faster, and errors are taken back by moving.
 */
final class HeldPlaces {

    private static final int MOST_STEPS = 12;

    /** Steps of Newton's method in islands that are not small, where contacts carry, too. */
    private static final int FEW_STEPS = 4;

    /** Share of its energy that an island may gain in them. */
    private static final double GAINED = 1e-4;

    /**
     * Share that a small island may gain whose places are held: turning takes and gives in turn.
     */
    private static final double GAINED_AT_MOST = 1e-2;

    /** What a step may leave of the error for the next one to be made alike. */
    private static final double GAINS = 0.2;

    private final Motions motions;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final NeutralRows ahead;
    private final JointRows rowsAhead;
    private final Poses poses;
    private final RowSolver solver;
    private final RowElimination elimination;
    private final UnsymmetricElimination foreseen;
    private final RowMemory memory;
    private final double tolerance;

    /** Whether the matrix of the end is wanted in the island that is solved. */
    private boolean isForeseen;

    /** Whether that matrix is factored for the set as it is. */
    private boolean isFactored;

    /** By row: how fast its place is to change besides, m/s. */
    private double[] wanted = new double[64];

    /** The most by which a place is missed, as a multiple of what it may be. */
    private double worst;

    HeldPlaces(
            Motions motions,
            NeutralRows rows,
            JointRows jointRows,
            NeutralRows ahead,
            JointRows rowsAhead,
            Poses poses,
            RowSolver solver,
            RowElimination elimination,
            UnsymmetricElimination foreseen,
            double tolerance) {
        this.motions = motions;
        this.rows = rows;
        this.jointRows = jointRows;
        this.ahead = ahead;
        this.rowsAhead = rowsAhead;
        this.poses = poses;
        this.solver = solver;
        this.elimination = elimination;
        this.foreseen = foreseen;
        this.tolerance = tolerance;
        memory = new RowMemory(motions, rows);
    }

    /** Begins an island. */
    void begin() {
        isForeseen = false;
    }

    /** Holds the places in a drift of h seconds; velocities count as solved but for so many m/s. */
    void hold(double h, double settled, boolean areContacts, boolean isSmall) {
        double energy = motions.energy(motions.data);
        memory.keep();
        double before = Double.POSITIVE_INFINITY;
        isFactored = false;
        measure(h);
        int most = areContacts && !isSmall ? FEW_STEPS : MOST_STEPS;
        for (int i = 0; i < most && worst > 1 && !elimination.isSpent(); i++) {
            if (!isForeseen && worst > GAINS * before && i > 0) {
                isForeseen = true;
                memory.recall();
                measure(h);
                before = Double.POSITIVE_INFINITY;
            }
            if (isForeseen && !(isFactored && worst <= GAINS * before)) {
                foresee(h);
                isFactored = true;
            }
            before = worst;
            step();
            if (areContacts) {
                aimAtPresent();
                // Other rows may be in the set from here on.
                solver.solveOn(settled);
                isFactored = false;
            }
            measure(h);
        }
        double gained = motions.energy(motions.data) / energy - 1;
        double allowed = isSmall && worst <= 1 ? GAINED_AT_MOST : GAINED;
        if (areContacts && gained > allowed) {
            memory.recall();
        }
    }

    /** Leaves velocities as they are in a drift. */
    void leave() {
        memory.keep();
        worst = 0;
    }

    /** Goes back to what {@link #hold} began with, which does no work and misses the places. */
    void release() {
        memory.recall();
    }

    /** Whether they were held in the last drift, within what may be missed. */
    boolean areHeld() {
        return worst <= 1;
    }

    /**
     * Limits and ropes that would be passed at the end of the drift enter the set: one that goes
     * along its stop, as a rope that is taut and turns, gives no reason to at the drift's start.
     */
    private void letEnter() {
        for (int row = 0; row < rows.count; row++) {
            boolean isStop = rows.holdsPlace[row] && !rows.isEquation(row) && rows.upper[row] > 0;
            if (isStop && !elimination.isIn(row)) {
                double beyond = Math.min(0, rows.place[row]) - jointRows.place(row);
                if (rows.inMetres(row, beyond) > allowed() && beyond > 0) {
                    solver.letIn(row);
                    isFactored = false;
                }
            }
        }
        elimination.factorize();
    }

    /** By how much the place that was measured last may be missed, m. */
    private double allowed() {
        return JointSolver.MISSED * tolerance * jointRows.size() + jointRows.roundOff();
    }

    private void foresee(double h) {
        ahead.clear();
        rowsAhead.write(h, h);
        elimination.factorize();
        foreseen.factorize(ahead);
    }

    private void step() {
        if (isForeseen) {
            foreseen.solve(wanted);
            for (int i = 0; i < elimination.size(); i++) {
                rows.push(elimination.row(i), foreseen.answer(i));
            }
        } else {
            elimination.solveFor(wanted);
            for (int i = 0; i < elimination.size(); i++) {
                rows.push(elimination.row(i), elimination.answer(i));
            }
        }
    }

    /** Asks what holds places for the speeds that it has, which hold them at the drift's end. */
    private void aimAtPresent() {
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            if (rows.holdsPlace[row]) {
                rows.target[row] += rows.residual(row);
            }
        }
    }

    /** Measures by how much places would be missed after a drift, and what changes that. */
    private void measure(double h) {
        if (wanted.length < rows.count) {
            wanted = new double[rows.bodies.length];
        }
        poses.take(h);
        jointRows.measureAnew();
        letEnter();
        worst = 0;
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            if (rows.holdsPlace[row]) {
                double place = rows.place[row];
                double kept = rows.isEquation(row) ? place : Math.min(0, place);
                double missed = jointRows.place(row) - kept;
                worst = Math.max(worst, rows.inMetres(row, missed) / allowed());
                wanted[row] = -missed / h;
            } else {
                wanted[row] = -rows.residual(row);
            }
        }
    }
}
