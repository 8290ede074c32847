package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
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

    /**
     * Compliance of rows with bounds towards changes of their last impulses, if they could share
     * their loads in more than one way: a share of their responses per metre of tolerance, and at
     * most. Without it, sets of rows that contradict each other by round-off followed each other
     * endlessly and pushed heaps about.
     */
    private static final double NEARNESS = 10;

    private static final double MOST_NEARNESS = 1e-2;

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

    private final Motions motions;
    private final NeutralRows rows;
    private final RowElimination elimination;
    private final ActiveRows active;
    private final SlidingRows sliding;
    private final RowDescent descent;

    /** The rows before sliding rows were solved together with their loads. */
    private final RowMemory apart;

    /**
     * Compliance of rows with bounds towards changes of their last impulses, as a share of their
     * responses.
     */
    private final double nearness;

    /**
     * Allowed lag of bounds in the last round, as a share of the largest speed that an impulse
     * gives its row.
     */
    private final double late;

    /** By row: target, compliance and impulse as they were written. */
    private double[] aim = new double[64];

    private double[] give = new double[64];
    private double[] carried = new double[64];

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
        boolean isExact = Effort.isExact(accuracy);
        nearness = isExact ? 0 : Math.min(MOST_NEARNESS, NEARNESS * accuracy.impactTolerance());
        late = LATE * accuracy.impactTolerance();
        this.motions = motions;
        this.rows = rows;
        this.elimination = elimination;
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
        keepAims();
        begin(packed, share, nearness > 0 && mayBeIndeterminate());
    }

    /**
     * Begins again with rows of which no impulse has been applied. Friction gets a compliance, as a
     * share of its response, towards changes of its last impulse, so that resting bodies do not
     * creep.
     */
    void beginSoftened(PackedJoints packed, double share, double softness) {
        for (int row = 0; row < rows.count; row++) {
            boolean isFriction = rows.contact[row] != NeutralRows.NONE && !rows.isPoint(row);
            rows.target[row] = aim[row];
            rows.give[row] = give[row];
            if (isFriction) {
                rows.give[row] = softness * rows.response[row];
                rows.target[row] += rows.give[row] * carried[row];
            }
        }
        begin(packed, share, false);
    }

    private void keepAims() {
        if (aim.length < rows.count) {
            aim = new double[rows.bodies.length];
            give = new double[rows.bodies.length];
            carried = new double[rows.bodies.length];
        }
        System.arraycopy(rows.target, 0, aim, 0, rows.count);
        System.arraycopy(rows.give, 0, give, 0, rows.count);
        System.arraycopy(rows.impulse, 0, carried, 0, rows.count);
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
                keepNear(row, before);
            }
            if (isOfJoint) {
                active.placeAsBefore(row, before);
            } else {
                active.placeContact(row);
            }
        }
    }

    /** Gives a row a compliance towards changes of its last impulse. */
    private void keepNear(int row, double before) {
        double give = nearness * rows.response[row];
        rows.give[row] += give;
        rows.target[row] += give * before;
    }

    /**
     * Whether rows may share their loads in more than one way: more of them hold than bodies have
     * degrees of freedom. Limits do not count, since most are not reached, nor do springs. Friction
     * counts only if there is a brake: two bodies that lie still on friction would otherwise creep
     * to where it would have held them anyway.
     */
    private boolean mayBeIndeterminate() {
        int free = 0;
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            free += motions.data[at + Motions.INVERSE_MASS] > 0 ? 2 : 0;
            free += motions.data[at + Motions.INVERSE_INERTIA] > 0 ? 1 : 0;
        }
        int hold = 0;
        int rub = 0;
        boolean isBraked = false;
        for (int row = 0; row < rows.count; row++) {
            boolean isOfJoint = rows.joint[row] != NeutralRows.NONE;
            boolean isLimit = isOfJoint && rows.holdsPlace[row] && !rows.isEquation(row);
            boolean isSoft =
                    isOfJoint && (rows.give[row] > 0 || rows.lower[row] == rows.upper[row]);
            boolean isOfLoad = rows.load[row] != NeutralRows.NONE;
            hold += isLimit || isSoft || isOfLoad ? 0 : 1;
            rub += isOfLoad ? 1 : 0;
            isBraked |= isOfJoint && !isLimit && !isSoft && !rows.isEquation(row);
        }
        return hold + (isBraked ? rub : 0) > free;
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
