package rigibo.backend.contact.joint;

/**
 * The active set of an island: all equations, and the rows with bounds that are within them. These
 * rows are eliminated. For every other row the bound is stored that the row is at.
 */
final class ActiveRows {

    /** Share of a bound from which an impulse counts as being at the bound. */
    private static final double AT_BOUND = 1 - 1e-9;

    /** Share of its limit from which friction counts as sliding. */
    private static final double SLID = 0.999;

    /**
     * Number of other rows along the coordinate of a joint's row: two limits and a motor share it.
     */
    private static final int MOST_RIVALS = 2;

    private final NeutralRows rows;
    private final RowElimination elimination;

    /** By row outside the set: the bound that it is at, −1 or 1. */
    int[] side = new int[64];

    /** The rows with bounds, which are all but equations, in order; and their number. */
    int[] bounded = new int[64];

    int boundedCount;

    /** Whether impulses are kept near those of the last kick. */
    private boolean areNear;

    ActiveRows(NeutralRows rows, RowElimination elimination) {
        this.rows = rows;
        this.elimination = elimination;
    }

    /**
     * Begins with rows that were just written. Equations are in the set; impulses of rows with
     * bounds are clamped to these, and the caller has to place each such row.
     */
    void begin(boolean areKeptNear) {
        areNear = areKeptNear;
        elimination.begin();
        if (side.length < rows.count) {
            side = new int[rows.bodies.length];
            bounded = new int[rows.bodies.length];
        }
        boundedCount = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.isEquation(row)) {
                elimination.put(row, true);
            } else {
                bounded[boundedCount++] = row;
            }
        }
        boundAll();
        clampAll();
    }

    /** Updates the bounds that depend on loads. */
    void boundAll() {
        for (int i = 0; i < boundedCount; i++) {
            rows.bound(bounded[i]);
        }
    }

    /** Puts a joint's row into the set or at a bound, by its impulse in the last kick, N·s. */
    void placeAsBefore(int row, double carried) {
        boolean isWithin =
                carried > AT_BOUND * rows.lower[row] && carried < AT_BOUND * rows.upper[row];
        if (carried == 0) {
            place(row);
        } else if (isWithin) {
            enter(row);
        } else {
            leave(row, carried > 0 ? 1 : -1);
        }
    }

    /**
     * Puts a contact's row into the set if it carried a load in the last kick; friction that slid
     * starts at its bound. Otherwise rows would have to be exchanged one by one where friction
     * sticks at two wheels, or where two bodies lie on a third.
     */
    void placeContact(int row) {
        double carried = rows.impulse[row];
        boolean isFriction = rows.load[row] != NeutralRows.NONE;
        if (isFriction && carried != 0 && Math.abs(carried) >= SLID * rows.upper[row]) {
            leave(row, carried > 0 ? 1 : -1);
        } else if (!isFriction && rows.isPoint(row) && carried > 0) {
            enter(row);
        } else {
            place(row);
        }
    }

    /**
     * Puts a row into the set if the impulse that solves it alone is within its bounds, otherwise
     * at a bound.
     */
    void place(int row) {
        double wish = rows.wish(row);
        if (wish > rows.lower[row] && wish < rows.upper[row]) {
            enter(row);
        } else {
            leave(row, wish >= rows.upper[row] ? 1 : -1);
        }
    }

    /** Places all rows with bounds again, by their present impulses and bounds. */
    void placeAnew() {
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            rows.bound(row);
            rows.push(row, within(row, rows.impulse[row]) - rows.impulse[row]);
            place(row);
        }
    }

    /** Removes a row from the set and puts it at a bound. */
    private void leave(int row, int bound) {
        side[row] = bound;
        elimination.put(row, false);
        toBound(row);
    }

    /** Adds a row to the set; its rival leaves the set and goes to its bound. */
    private void enter(int row) {
        int rival = takeRivalOut(row);
        if (rival != NeutralRows.NONE) {
            toBound(rival);
        }
        elimination.put(row, true);
    }

    /** Adds a row to the set; its rival leaves the set and keeps its impulse. */
    void letIn(int row) {
        takeRivalOut(row);
        elimination.put(row, true);
    }

    /**
     * Removes the row's rival from the set and returns it: another row of its joint along the same
     * coordinate. A limit and a brake that are both in the set ask for two speeds; the least
     * difference drove them against each other by 10¹² N·s. Rows that are kept near their last
     * impulses share the load instead.
     */
    private int takeRivalOut(int row) {
        int joint = areNear ? NeutralRows.NONE : rows.joint[row];
        for (int i = row - MOST_RIVALS; joint != NeutralRows.NONE && i <= row + MOST_RIVALS; i++) {
            boolean isOfJoint = i >= 0 && i < rows.count && i != row && rows.joint[i] == joint;
            if (isOfJoint && elimination.isIn(i) && !rows.isEquation(i)) {
                double sign = rows.parallel(row, i);
                if (sign != 0) {
                    boolean isBack = sign * rows.target[row] > rows.target[i];
                    side[i] = isBack || rows.upper[i] == Double.POSITIVE_INFINITY ? -1 : 1;
                    elimination.put(i, false);
                    return i;
                }
            }
        }
        return NeutralRows.NONE;
    }

    /** Moves a row from the set to the bound that it exceeds, or into the set. */
    void exchange(int row) {
        if (elimination.isIn(row)) {
            leave(row, rows.impulse[row] > rows.upper[row] ? 1 : -1);
        } else {
            enter(row);
        }
    }

    private void toBound(int row) {
        double bound = side[row] > 0 ? rows.upper[row] : rows.lower[row];
        rows.push(row, bound - rows.impulse[row]);
    }

    private void clampAll() {
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            double within = within(row, rows.impulse[row]);
            if (within != rows.impulse[row]) {
                rows.push(row, within - rows.impulse[row]);
            }
        }
    }

    /** An impulse clamped to a row's bounds, N·s. */
    private double within(int row, double impulse) {
        return Math.max(rows.lower[row], Math.min(rows.upper[row], impulse));
    }

    /**
     * The impulse that a row must have by its bounds: outside the set the bound, inside it the
     * clamped impulse.
     */
    double due(int row) {
        double bound = side[row] > 0 ? rows.upper[row] : rows.lower[row];
        return elimination.isIn(row) ? within(row, rows.impulse[row]) : bound;
    }

    /**
     * How far a row whose bounds depend on a load or a twin is from the impulse that it must have,
     * as a speed in m/s.
     */
    double lag(int row) {
        boolean follows = rows.load[row] != NeutralRows.NONE || rows.twin[row] != NeutralRows.NONE;
        double change = follows ? due(row) - rows.impulse[row] : 0;
        return rows.inMetres(row, change) * rows.response[row];
    }
}
