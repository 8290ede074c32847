package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

/**
 * Solves an island all of whose rows are eliminated together. A solution that would do work that
 * its rows cannot do is discarded; passes that start from impulses of 0 never do any.
 */
final class WholeSolver {

    /** Residual that counts as solved, as a share of the fastest speed, per metre of tolerance. */
    private static final double SETTLED = 1e-3;

    /**
     * Overlap that is left in an island too taut, where each push asks for an elimination, in
     * widths.
     */
    private static final double UNTOLD = 1e-3;

    /** Compliances of friction if rows have no solution otherwise, as shares of its response. */
    private static final double[] GIVES_WAY = {1e-3, 0.1};

    private final PackedJoints packed;
    private final ContactRows contactRows;
    private final RowElimination elimination;
    private final RowSolver solver;
    private final HeldPlaces places;
    private final PlaceRecovery recovery;
    private final JointedOverlap overlap;
    private final JointBudget budget;
    private final JointSubsteps needed;
    private final RowWork work;
    private final AllowedWork allowed;
    private final RowPasses passes;
    private final double tolerance;

    WholeSolver(
            Motions motions,
            NeutralRows rows,
            PackedJoints packed,
            ContactRows contactRows,
            RowElimination elimination,
            RowSolver solver,
            HeldPlaces places,
            PlaceRecovery recovery,
            JointedOverlap overlap,
            JointBudget budget,
            JointSubsteps needed,
            double tolerance) {
        this.packed = packed;
        this.contactRows = contactRows;
        this.elimination = elimination;
        this.solver = solver;
        this.places = places;
        this.recovery = recovery;
        this.overlap = overlap;
        this.budget = budget;
        this.needed = needed;
        work = new RowWork(motions, rows, solver.near);
        allowed = new AllowedWork(motions, work);
        passes = new RowPasses(rows);
        this.tolerance = tolerance;
    }

    /** Begins an island of which nothing has been solved in the step yet. */
    void beginIsland() {
        places.begin();
        solver.beginIsland();
        passes.begin();
    }

    /** Number of row solutions by passes since the island began. */
    long solves() {
        return passes.solves();
    }

    /**
     * Solves the rows, which are written, after a kick, so that places are held at the end of a
     * drift of h seconds.
     *
     * @param carried share of the last kick's impulses that joints start with
     * @param fastest fastest speed after the kick, m/s
     * @param noise energy that does not count, J
     * @param finer factor on the residual that counts as solved
     */
    void solve(double h, double carried, double fastest, double noise, double finer) {
        double settled = settled(finer, fastest);
        work.begin();
        allowed.begin(contactRows.areAny() ? needed.turning() * Math.abs(h) : 0);
        boolean isSolved = solveRows(carried, settled);
        if (needed.isTaut()) {
            // Kicks along the rows at the start would tremble against the larger inertia.
            places.leave();
        } else {
            places.hold(h, settled, contactRows.carry(), budget.isSmall(), allowed.explained());
        }
        boolean isGained = allowed.isExceeded(places.areHeld(), noise);
        if (isGained && !contactRows.carry() || areStrained(fastest)) {
            places.release();
        }
        secure(isSolved, isGained, settled, fastest);
        contactRows.store();
    }

    /** Solves the rows likewise, after the last kick of a substep, after which nothing drifts. */
    void solveAtRest(double carried, double fastest, double noise, double finer) {
        double settled = settled(finer, fastest);
        work.begin();
        allowed.begin(0);
        boolean isSolved = solveRows(carried, settled);
        secure(isSolved, allowed.isExceeded(false, noise), settled, fastest);
        contactRows.store();
    }

    /**
     * Solves the rows; returns whether it could. A load and the friction that it allows may hold a
     * body from both sides, as a wedge is held. Rows whose targets differ by the least then have no
     * solution, and their friction gives way a little.
     */
    private boolean solveRows(double carried, double settled) {
        solver.beginAsBefore(packed, carried);
        boolean isSolved = solver.solve(settled);
        for (int i = 0; i < GIVES_WAY.length && !isSolved && mayGiveWay(); i++) {
            work.takeBack();
            solver.beginSoftened(packed, carried, GIVES_WAY[i]);
            isSolved = solver.solve(settled);
        }
        return isSolved;
    }

    private double settled(double finer, double fastest) {
        return finer * SETTLED * tolerance * fastest;
    }

    private boolean mayGiveWay() {
        return contactRows.areAny() && !elimination.isSpent() && !needed.isTaut();
    }

    /** Whether contacts carry stress; a taut island carries any load without contradiction. */
    private boolean areStrained(double fastest) {
        return !needed.isTaut() && contactRows.areStrained(fastest);
    }

    /**
     * Replaces a solution that could not be found, or that does work, by one with targets at rest
     * where joints press, or else by passes from impulses of 0, after which equations are solved
     * again.
     */
    private void secure(boolean isSolved, boolean isGained, double settled, double fastest) {
        boolean areAny = isSolved ? contactRows.carry() : contactRows.areAny();
        boolean mayDoWork = areAny || elimination.isSpent() || allowed.isAnyDriven(isSolved);
        boolean isNone = isSolved && !isGained && allowed.isNone();
        if (mayDoWork && !isNone) {
            // Passes would not find what a spring, a motor or a limit presses with.
            boolean isPressed =
                    isSolved && !elimination.isSpent() && contactRows.strongestDrive() > fastest;
            work.takeBack();
            work.rest();
            if (!isPressed || !isSolvedAtRest(settled)) {
                work.takeBack();
                passes.run(budget.mostPasses(), settled);
                solver.holdEquations();
            }
        }
    }

    /** Solves rows whose targets are at rest; returns whether they do no work then. */
    private boolean isSolvedAtRest(double settled) {
        solver.begin();
        return solver.solve(settled) && allowed.isNone();
    }

    /** Removes overlap with joints held, after a drift of h seconds. */
    void correctOverlap(double h) {
        overlap.correct(h, needed.isWedged() ? UNTOLD : 0);
    }

    /** Removes the position errors of joints by moving bodies, after a drift of h seconds. */
    void correctPlaces(double h) {
        // Taut joints close by themselves.
        if (!needed.isWedged()) {
            recovery.correct(h);
        }
    }
}
