package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/**
 * Finds the impulses with which joints hold their places at the end of a drift, where rows have
 * turned. It uses Newton's method, with the matrix at the start of the drift as long as that
 * converges fast, then with the matrix at its end. Loaded contacts may nearly contradict joints.
 * Impulses that would make such bodies faster are discarded, and {@link PlaceRecovery} removes the
 * errors by moving bodies.
 */
final class HeldPlaces {

    private static final int MOST_STEPS = 24;

    /** Most Newton steps in islands that are not small and whose contacts carry load. */
    private static final int FEW_STEPS = 4;

    /** Share of its energy that such an island may gain. */
    private static final double GAINED = 1e-4;

    /** Share of the error that a step may leave for the next step to use the same matrix. */
    private static final double GAINS = 0.2;

    private final Motions motions;
    private final NeutralRows rows;
    private final JointPlaces jointPlaces;
    private final NeutralRows ahead;
    private final JointRows rowsAhead;
    private final Poses poses;
    private final RowSolver solver;
    private final RowElimination elimination;
    private final UnsymmetricElimination foreseen;
    private final RowMemory memory;
    private final double tolerance;

    /** Whether the present island needs the matrix at the end of the drift. */
    private boolean isForeseen;

    /** Whether that matrix is factored for the present set. */
    private boolean isFactored;

    /** By row: the change of speed that closes its place, m/s. */
    private double[] wanted = new double[64];

    /** Largest error of a place, as a multiple of the allowed one. */
    private double worst;

    HeldPlaces(
            Motions motions,
            NeutralRows rows,
            JointPlaces jointPlaces,
            NeutralRows ahead,
            JointRows rowsAhead,
            Poses poses,
            RowSolver solver,
            RowElimination elimination,
            double tolerance) {
        this.motions = motions;
        this.rows = rows;
        this.jointPlaces = jointPlaces;
        this.ahead = ahead;
        this.rowsAhead = rowsAhead;
        this.poses = poses;
        this.solver = solver;
        this.elimination = elimination;
        foreseen = new UnsymmetricElimination(motions, rows, elimination);
        this.tolerance = tolerance;
        memory = new RowMemory(motions, rows);
    }

    /** Begins an island. */
    void begin() {
        isForeseen = false;
    }

    /**
     * Holds the places in a drift of h seconds; velocities count as solved within {@code settled}
     * m/s.
     *
     * @param explained share of its energy that a small island with contacts may gain if its places
     *     are held: rows that turn take and give energy in turn
     */
    void hold(double h, double settled, boolean areContacts, boolean isSmall, double explained) {
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
                // The set may have changed.
                solver.solveOn(settled);
                isFactored = false;
            }
            measure(h);
        }
        double gained = motions.energy(motions.data) / energy - 1;
        double allowed = isSmall && worst <= 1 ? explained : GAINED;
        if (areContacts && gained > allowed) {
            memory.recall();
        }
    }

    /** Leaves velocities as they are in a drift. */
    void leave() {
        memory.keep();
        worst = 0;
    }

    /**
     * Restores the velocities that {@link #hold} began with, which do no work and miss the places.
     */
    void release() {
        memory.recall();
    }

    /** Whether places are held in the last drift, within the allowed error. */
    boolean areHeld() {
        return worst <= 1;
    }

    /**
     * Adds limits and ropes to the set that would be passed at the end of the drift. A body that
     * moves along its stop, as on a taut rope that turns, does not approach it at the start of the
     * drift.
     */
    private void letEnter() {
        for (int row = 0; row < rows.count; row++) {
            boolean isStop = rows.holdsPlace[row] && !rows.isEquation(row) && rows.upper[row] > 0;
            if (isStop && !elimination.isIn(row)) {
                double beyond = Math.min(0, rows.place[row]) - jointPlaces.of(row);
                if (rows.inMetres(row, beyond) > allowed() && beyond > 0) {
                    solver.letIn(row);
                    isFactored = false;
                }
            }
        }
        elimination.factorize();
    }

    /** Allowed error of the place that was measured last, m. */
    private double allowed() {
        return JointPlaces.MISSED * tolerance * jointPlaces.size() + jointPlaces.roundOff();
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

    /**
     * Makes the present speeds of rows that hold places their targets, since these hold the places
     * at the end of the drift.
     */
    private void aimAtPresent() {
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            if (rows.holdsPlace[row]) {
                rows.target[row] += rows.residual(row);
            }
        }
    }

    /** Measures the errors of places after a drift, and the changes of speed that close them. */
    private void measure(double h) {
        if (wanted.length < rows.count) {
            wanted = new double[rows.bodies.length];
        }
        poses.take(h);
        jointPlaces.measureAnew();
        letEnter();
        worst = 0;
        for (int i = 0; i < elimination.size(); i++) {
            int row = elimination.row(i);
            if (rows.holdsPlace[row]) {
                double place = rows.place[row];
                double kept = rows.isEquation(row) ? place : Math.min(0, place);
                double missed = jointPlaces.of(row) - kept;
                worst = Math.max(worst, rows.inMetres(row, missed) / allowed());
                wanted[row] = -missed / h;
            } else {
                wanted[row] = -rows.residual(row);
            }
        }
    }
}
