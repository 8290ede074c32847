package rigibo.backend.contact.joint;

/**
 * Solves rows with constant bounds if exchanges of the set do not end. It starts with impulses
 * within their bounds and moves towards those that solve the rows of the set, until a first row
 * reaches a bound; that row leaves the set. Once the set is solved, the row enters that is driven
 * off its bound most. Each step lowers the energy of the residuals, so that no set occurs twice (J.
 * Nocedal and S. Wright, Numerical Optimization, 2006, on active sets of convex quadratic
 * programs).
 */
final class RowDescent {

    /**
     * Most refinements of a solution with the same set, which restore the digits that elimination
     * lost.
     */
    private static final int REFINEMENTS = 3;

    /** Most steps: for each row with bounds, and in addition. */
    private static final int STEPS_EACH = 4;

    private static final int STEPS = 16;

    private static final int NONE = NeutralRows.NONE;

    private final NeutralRows rows;
    private final RowElimination elimination;

    /** The rows with bounds; and by row outside the set the bound that it is at, −1 or 1. */
    private int[] bounded;

    private int count;
    private int[] side;

    /** Residual that counts as solved, m/s. */
    private double settled;

    RowDescent(NeutralRows rows, RowElimination elimination) {
        this.rows = rows;
        this.elimination = elimination;
    }

    /**
     * Solves up to a residual of {@code most} m/s; returns whether it could. {@code sides} holds
     * the bound of each row outside the set, −1 or 1.
     */
    boolean solve(int[] withBounds, int countOfThem, int[] sides, double most) {
        bounded = withBounds;
        count = countOfThem;
        side = sides;
        settled = most;
        clamp();
        int steps = STEPS + STEPS_EACH * count;
        int same = 0;
        for (int i = 0; i < steps && !elimination.isSpent(); i++) {
            elimination.factorize();
            double lacking = elimination.askForResiduals();
            boolean isSolved = same > 0 && lacking <= settled || same == REFINEMENTS;
            if (!isSolved) {
                same = step() ? 0 : same + 1;
            } else if (letIn()) {
                same = 0;
            } else {
                return true;
            }
        }
        return false;
    }

    /** Clamps all impulses to their bounds; a row at a bound leaves the set. */
    private void clamp() {
        for (int i = 0; i < count; i++) {
            int row = bounded[i];
            double impulse = rows.impulse[row];
            if (elimination.isIn(row) && impulse >= rows.upper[row]) {
                leave(row, 1);
            } else if (elimination.isIn(row) && impulse <= rows.lower[row]) {
                leave(row, -1);
            }
        }
    }

    private void leave(int row, int at) {
        side[row] = at;
        elimination.put(row, false);
        rows.push(row, (at > 0 ? rows.upper[row] : rows.lower[row]) - rows.impulse[row]);
    }

    /**
     * Moves impulses to the solution of the set, or until the first of them reaches a bound;
     * returns whether one did.
     */
    private boolean step() {
        elimination.solve();
        double share = 1;
        int first = NONE;
        for (int k = 0; k < elimination.size(); k++) {
            int row = elimination.row(k);
            double change = elimination.answer(k);
            double bound = change > 0 ? rows.upper[row] : rows.lower[row];
            double left = Math.max(0, (bound - rows.impulse[row]) / change);
            if (change != 0 && left < share) {
                share = left;
                first = row;
            }
        }
        int at = 0;
        for (int k = 0; k < elimination.size(); k++) {
            int row = elimination.row(k);
            double change = elimination.answer(k);
            rows.push(row, share * change);
            at = row == first ? change > 0 ? 1 : -1 : at;
        }
        if (first != NONE) {
            leave(first, at);
        }
        return first != NONE;
    }

    /** Adds the row to the set that is driven off its bound most; returns whether there was any. */
    private boolean letIn() {
        int entering = NONE;
        double most = settled;
        for (int i = 0; i < count; i++) {
            int row = bounded[i];
            double drive = rows.unit[row] * side[row] * rows.residual(row);
            if (!elimination.isIn(row) && drive > most && isOpen(row)) {
                most = drive;
                entering = row;
            }
        }
        if (entering != NONE) {
            elimination.put(entering, true);
        }
        return entering != NONE;
    }

    /** Whether the bounds of a row are far enough apart for it to enter the set. */
    private boolean isOpen(int row) {
        double slack = settled / rows.unit[row] / rows.response[row];
        return rows.upper[row] - rows.lower[row] > 2 * slack;
    }
}
