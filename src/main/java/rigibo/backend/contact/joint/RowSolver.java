package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/**
 * Solves the rows of an island to the end. Equations are always eliminated; of the rows with bounds
 * those are that are within them. Rows that leave their bounds leave the set and rows that are
 * driven off their bounds enter it, all at once as long as they get fewer (Júdice and Pires,
 * Basic-set algorithm for a generalized linear complementarity problem, 1994), else one at a time
 * ({@link RowDescent}). Bounds that follow from loads follow between two such solutions; where a
 * few of these did not end, what slides is solved together with its loads ({@link SlidingRows}).
 */
final class RowSolver {

    /** Exchanges of all rows at once that may fail to make them fewer. */
    private static final int PATIENCE = 5;

    /**
     * What rows with bounds give way by for what they carry else than in the kick before, where
     * they could share their loads in more than one way: a share of their responses, for each metre
     * of the tolerance, and at most. Sets of rows that contradict each other by round-off followed
     * each other without an end, and what lay in a heap was pushed about by it.
     */
    private static final double NEARNESS = 10;

    private static final double MOST_NEARNESS = 1e-2;

    /** Exchanges in one solution, and how often bounds follow loads. */
    private static final int MOST_EXCHANGES = 60;

    private static final int MOST_ROUNDS = 20;

    /** Rounds in which bounds follow loads before what slides is solved with them. */
    private static final int ROUNDS_APART = 3;

    /** Solutions with the same set that take back what elimination lost of digits. */
    private static final int REFINEMENTS = 3;

    /** Share of the strongest answer below which a speed is round-off. */
    private static final double ROUND_OFF = 2e-15;

    /** What a bound may lag behind its loads, as a multiple of what counts as solved. */
    private static final double LAG = 100;

    /**
     * Share of the strongest speed that bounds may lag behind once rounds end, for each metre of
     * the tolerance: at GAME friction is then known to a thousandth.
     */
    private static final double LATE = 10;

    private final Motions motions;
    private final NeutralRows rows;
    private final RowElimination elimination;
    private final ActiveRows active;
    private final SlidingRows sliding;
    private final RowDescent descent;

    /** How rows were before what slides was solved with its loads. */
    private final RowMemory apart;

    /** What rows with bounds give way by for what they carry else than in the kick before. */
    private final double nearness;

    /** Share of the strongest speed that bounds may lag behind once rounds end. */
    private final double late;

    /** By row: target, give and impulse as they were written. */
    private double[] aim = new double[64];

    private double[] give = new double[64];
    private double[] carried = new double[64];

    /** Rows to be exchanged. */
    private int wrong;

    /** What counts as solved, m/s, and whether the set's rows may be from the start. */
    private double settled;

    private boolean isNear;

    /** Whether what slides is solved with its loads. */
    private boolean isTogether;

    /**
     * Whether that was needed when the island was solved last, as by a chain that runs over a
     * wheel; then it is likely to be needed again.
     */
    private boolean beginsTogether;

    RowSolver(Motions motions, NeutralRows rows, RowElimination elimination, Accuracy accuracy) {
        boolean isExact = accuracy.substeps() >= Accuracy.EXACT.substeps();
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

    /** Begins an island, of which nothing was solved yet in the step. */
    void beginIsland() {
        beginsTogether = false;
    }

    /**
     * Begins with rows that were just written, with impulses that bodies have got already; of what
     * is beyond its bounds they get the difference.
     */
    void begin() {
        active.begin(false);
        for (int i = 0; i < active.boundedCount; i++) {
            active.place(active.bounded[i]);
        }
    }

    /**
     * Begins likewise, with limits and motors in the set that were within their bounds in the kick
     * before, and those at a bound that were at it, as far as a share of what they carried tells.
     */
    void beginAsBefore(PackedJoints packed, double share) {
        keepAims();
        begin(packed, share, nearness > 0 && mayBeIndeterminate());
    }

    /**
     * Begins anew with rows of which bodies have got nothing. Friction gives way, by a share of its
     * response, to what it would carry else than before: what rests does not creep.
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

    /** Lets the impulse of a row differ from that of the kick before only as far as it must. */
    private void keepNear(int row, double before) {
        double give = nearness * rows.response[row];
        rows.give[row] += give;
        rows.target[row] += give * before;
    }

    /**
     * Whether rows may share their loads in more than one way: more of them hold than bodies can
     * move by. Limits count for nothing, for most are not reached, nor do springs, nor friction
     * where nothing brakes: two bodies that lie still on it crept to where it would have held them
     * anyway.
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

    /** Takes a row with bounds into the set before {@link #solveOn}. */
    void letIn(int row) {
        active.letIn(row);
    }

    /** Solves but for so many m/s, and answers whether it could. */
    boolean solve(double most) {
        isNear = false;
        return solveRounds(most);
    }

    /**
     * Goes on solving after a change that left the rows of the set solved, but maybe not others.
     */
    void solveOn(double most) {
        isNear = true;
        solveRounds(most);
    }

    private boolean solveRounds(double most) {
        settled = Math.max(most, ROUND_OFF * strongest());
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
                // Rows that jam have no answer, or several: back to where they were.
                isTogether = false;
                beginsTogether = false;
                goApart();
            } else {
                return false;
            }
        }
        return false;
    }

    /** Goes back to how rows were before what slides was solved with its loads. */
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

    /** Solves with the bounds as they are; whether it came to an end. */
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

    /** Brings the set's rows to what they ask for. */
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

    /** Eliminates rows together with what slides under their loads, within bounds of now. */
    private void eliminateTogether() {
        sliding.begin(active.side);
        for (int i = 0; i < REFINEMENTS && !(sliding.ask() <= settled && i > 0); i++) {
            sliding.push();
        }
        sliding.bound();
    }

    /** Counts the rows that are in the set beyond their bounds, or out of it wrongly. */
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

    /** By how much, in m/s, what follows loads is off its bound at most. */
    private double lag() {
        double most = 0;
        for (int i = 0; i < active.boundedCount; i++) {
            most = Math.max(most, active.lag(active.bounded[i]));
        }
        return most;
    }

    /** Lets rows follow bounds that have moved with their loads. */
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

    /** Brings equations to what they ask for, whatever the other rows do. */
    void holdEquations() {
        for (int row = 0; row < rows.count; row++) {
            elimination.put(row, rows.isEquation(row));
        }
        // What counted as solved may have been measured at impulses beyond all bounds.
        settled = ROUND_OFF * strongest();
        isNear = false;
        eliminate();
    }
}
