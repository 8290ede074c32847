package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/**
 * Solves the rows of an island completely. Equations and rows within their bounds are eliminated.
 * Rows that exceed their bounds leave the set, and rows that are driven off their bounds enter it:
 * all at once as long as their number falls (Júdice and Pires, Basic-set algorithm for a
 * generalized linear complementarity problem, 1994), otherwise one at a time ({@link RowDescent}).
 * Bounds that depend on loads are updated between two such solutions. If a few updates do not end,
 * sliding rows are solved together with their loads ({@link SlidingRows}).
 */
final class RowSolver {

    /** Most successive exchanges of all rows at once that do not lower their number. */
    private static final int PATIENCE = 5;

    /** Most exchanges in one solution, and most updates of bounds that depend on loads. */
    private static final int MOST_EXCHANGES = 60;

    private static final int MOST_ROUNDS = 20;

    /** Updates of bounds after which sliding rows are solved together with their loads. */
    private static final int ROUNDS_APART = 3;

    /**
     * Most refinements of a solution with the same set, which restore the digits that elimination
     * lost.
     */
    private static final int REFINEMENTS = 3;

    /** Share of the strongest answer below which a speed is round-off. */
    private static final double SPEED_ROUND_OFF = 2e-15;

    /**
     * Allowed lag of a bound behind its loads, as a multiple of the residual that counts as solved.
     */
    private static final double LAG = 100;

    /**
     * Allowed lag of bounds in the last round, as a share of the largest speed that an impulse
     * gives its row, per metre of tolerance: at GAME friction is then known to a thousandth.
     */
    private static final double LATE = 10;

    private final NeutralRows rows;
    private final RowElimination elimination;
    private final ActiveRows active;
    final NearRows near;
    private final SlidingRows sliding;
    private final RowDescent descent;

    /** The rows before sliding rows were solved together with their loads. */
    private final RowMemory apart;

    /**
     * Allowed lag of bounds in the last round, as a share of the largest speed that an impulse
     * gives its row.
     */
    private final double late;

    /** Number of rows to be exchanged. */
    private int wrong;

    /**
     * Residual that counts as solved, m/s; and whether the set's rows may be solved at the start.
     */
    private double settled;

    private boolean isNear;

    /** Whether sliding rows are solved together with their loads. */
    private boolean isTogether;

    /**
     * Whether that was needed when the island was solved last, as for a chain that runs over a
     * wheel; it is then likely to be needed again.
     */
    private boolean beginsTogether;

    RowSolver(Motions motions, NeutralRows rows, RowElimination elimination, Accuracy accuracy) {
        late = LATE * accuracy.impactTolerance();
        this.rows = rows;
        this.elimination = elimination;
        near = new NearRows(motions, rows, accuracy);
        active = new ActiveRows(rows, elimination);
        sliding = new SlidingRows(motions, rows, elimination);
        descent = new RowDescent(rows, elimination);
        apart = new RowMemory(motions, rows);
    }

    /** Begins an island of which nothing has been solved in the step yet. */
    void beginIsland() {
        beginsTogether = false;
    }

    /**
     * Begins with rows that were just written and whose impulses have been applied; impulses beyond
     * bounds are clamped.
     */
    void begin() {
        active.begin(false);
        for (int i = 0; i < active.boundedCount; i++) {
            active.place(active.bounded[i]);
        }
    }

    /**
     * Begins likewise. Limits and motors start in the set, or at the bound, at which they ended the
     * last kick, whose impulses are scaled by {@code share}.
     */
    void beginAsBefore(PackedJoints packed, double share) {
        near.begin();
        begin(packed, share, near.areWanted());
    }

    /**
     * Begins again with rows of which no impulse has been applied. Friction gets a compliance, as a
     * share of its response, towards changes of its last impulse, so that resting bodies do not
     * creep.
     */
    void beginSoftened(PackedJoints packed, double share, double softness) {
        near.soften(softness);
        begin(packed, share, false);
    }

    private void begin(PackedJoints packed, double share, boolean isNear) {
        active.begin(isNear);
        for (int i = 0; i < active.boundedCount; i++) {
            int row = active.bounded[i];
            boolean isOfJoint = rows.joint[row] != NeutralRows.NONE;
            double before =
                    isOfJoint
                            ? share * packed.impulseOf(rows.joint[row], rows.part[row])
                            : rows.impulse[row];
            if (isNear) {
                near.keep(row, before);
            }
            if (isOfJoint) {
                active.placeAsBefore(row, before);
            } else {
                active.placeContact(row);
            }
        }
    }

    /** Adds a row with bounds to the set before {@link #solveOn}. */
    void letIn(int row) {
        active.letIn(row);
    }

    /** Solves up to a residual in m/s; returns whether it could. */
    boolean solve(double most) {
        isNear = false;
        return solveRounds(most);
    }

    /** Continues after a change that left the rows of the set solved, but maybe not the others. */
    void solveOn(double most) {
        isNear = true;
        solveRounds(most);
    }

    private boolean solveRounds(double most) {
        settled = Math.max(most, SPEED_ROUND_OFF * strongest());
        isTogether = beginsTogether;
        if (isTogether) {
            apart.keep();
        }
        for (int round = 0; round < MOST_ROUNDS && !elimination.isSpent(); round++) {
            if (round == ROUNDS_APART && !isTogether) {
                isTogether = true;
                apart.keep();
            }
            boolean isSolved = exchange();
            if (isSolved) {
                active.boundAll();
                boolean isLast = round == MOST_ROUNDS - 1 || elimination.isSpent();
                double share = isLast ? late : 0;
                if (lag() <= Math.max(LAG * settled, share * strongest())) {
                    beginsTogether = isTogether;
                    return true;
                }
                follow();
            } else if (isTogether) {
                // Rows that jam have no solution, or several.
                isTogether = false;
                beginsTogether = false;
                goApart();
            } else {
                return false;
            }
        }
        return false;
    }

    /** Restores the rows before sliding rows were solved together with their loads. */
    private void goApart() {
        apart.recall();
        active.placeAnew();
    }

    private double strongest() {
        double most = 0;
        for (int row = 0; row < rows.count; row++) {
            most = Math.max(most, rows.ownSpeed(row));
        }
        return most;
    }

    /** Solves with the present bounds; returns whether it could. */
    private boolean exchange() {
        int fewest = Integer.MAX_VALUE;
        int patience = PATIENCE;
        for (int i = 0; i < MOST_EXCHANGES && !elimination.isSpent(); i++) {
            if (isTogether) {
                eliminateTogether();
            } else {
                eliminate();
            }
            find();
            if (wrong == 0) {
                return true;
            }
            if (wrong < fewest) {
                fewest = wrong;
                patience = PATIENCE;
            } else {
                patience--;
            }
            if (patience > 0) {
                exchangeAll();
            } else if (isTogether) {
                return false;
            } else {
                return descent.solve(active.bounded, active.boundedCount, active.side, settled);
            }
        }
        return false;
    }

    /** Solves the rows of the set. */
    private void eliminate() {
        elimination.factorize();
        for (int i = 0;
                i < REFINEMENTS && !(elimination.askForResiduals() <= settled && (i > 0 || isNear));
                i++) {
            elimination.solve();
            for (int k = 0; k < elimination.size(); k++) {
                rows.push(elimination.row(k), elimination.answer(k));
            }
        }
    }

    /** Solves the rows of the set together with the rows that slide by their loads. */
    private void eliminateTogether() {
        sliding.begin(active.side);
        for (int i = 0; i < REFINEMENTS && !(sliding.ask() <= settled && i > 0); i++) {
            sliding.push();
        }
        sliding.bound();
    }

    /**
     * Counts the rows in the set that exceed their bounds, and the rows outside it that are driven
     * off them.
     */
    private void find() {
        wrong = 0;
        for (int i = 0; i < active.boundedCount; i++) {
            if (isWrong(active.bounded[i])) {
                wrong++;
            }
        }
    }

    private boolean isWrong(int row) {
        double most = settled / rows.unit[row];
        double slack = most / rows.response[row];
        double impulse = rows.impulse[row];
        if (elimination.isIn(row)) {
            return impulse < rows.lower[row] - slack || impulse > rows.upper[row] + slack;
        }
        return rows.upper[row] - rows.lower[row] > 2 * slack
                && active.side[row] * rows.residual(row) > most;
    }

    private void exchangeAll() {
        for (int i = 0; i < active.boundedCount; i++) {
            if (isWrong(active.bounded[i])) {
                active.exchange(active.bounded[i]);
            }
        }
    }

    /** Largest lag of a row whose bounds depend on loads, m/s. */
    private double lag() {
        double most = 0;
        for (int i = 0; i < active.boundedCount; i++) {
            most = Math.max(most, active.lag(active.bounded[i]));
        }
        return most;
    }

    /** Moves rows to bounds that have changed with their loads. */
    private void follow() {
        for (int i = 0; i < active.boundedCount; i++) {
            int row = active.bounded[i];
            if (active.lag(row) > LAG * settled) {
                if (elimination.isIn(row)) {
                    active.exchange(row);
                } else {
                    rows.push(row, active.due(row) - rows.impulse[row]);
                }
            }
        }
    }

    /** Solves the equations alone, with the present impulses of all other rows. */
    void holdEquations() {
        for (int row = 0; row < rows.count; row++) {
            elimination.put(row, rows.isEquation(row));
        }
        // The allowed residual may have been measured with impulses beyond all bounds.
        settled = SPEED_ROUND_OFF * strongest();
        isNear = false;
        eliminate();
    }
}
