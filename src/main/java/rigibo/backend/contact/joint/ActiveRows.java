package rigibo.backend.contact.joint;

/**
 * The rows of an island that are eliminated: all equations, and those with bounds that are within
 * them. Of the others it knows at which bound each is.
 */
final class ActiveRows {

    /** Share of a bound from which on what was carried counts as at it. */
    private static final double AT_BOUND = 1 - 1e-9;

    /** Share of what friction may carry from which on a contact counts as sliding. */
    private static final double SLID = 0.999;

    /** Rows of a joint along one coordinate, two limits and a motor, besides one of them. */
    private static final int MOST_RIVALS = 2;

    private final NeutralRows rows;
    private final RowElimination elimination;

    /** By row: at which bound it is while it is out of the set, −1 or 1. */
    int[] side = new int[64];

    /** The rows with bounds, all but equations, in their order. */
    int[] bounded = new int[64];

    int boundedCount;

    /** Whether rows are kept near what they carried. */
    private boolean areNear;

    ActiveRows(NeutralRows rows, RowElimination elimination) {
        this.rows = rows;
        this.elimination = elimination;
    }

    /**
     * Begins with rows that were just written. Equations are in the set; rows with bounds carry
     * what is within them, and are to be placed.
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

    /** Lets bounds follow the loads that they depend on. */
    void boundAll() {
        for (int i = 0; i < boundedCount; i++) {
            rows.bound(bounded[i]);
        }
    }

    /** Takes a row of a joint in or out of the set by what it carried in the kick before, N·s. */
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
     * Takes the row of a contact into the set if it carried a load in the kick before, and leaves
     * friction at its bound that slid. What sticks at two wheels at once, or where two bodies lie
     * on a third, would else be found out by exchanging rows one after the other.
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

    /** Takes a row with bounds into the set, if alone it would be within them. */
    void place(int row) {
        double wish = rows.wish(row);
        if (wish > rows.lower[row] && wish < rows.upper[row]) {
            enter(row);
        } else {
            leave(row, wish >= rows.upper[row] ? 1 : -1);
        }
    }

    /** Places all rows with bounds anew, by what they carry and by bounds of now. */
    void placeAnew() {
        for (int i = 0; i < boundedCount; i++) {
            int row = bounded[i];
            rows.bound(row);
            rows.push(row, within(row, rows.impulse[row]) - rows.impulse[row]);
            place(row);
        }
    }

    /** Takes a row with bounds out of the set, to one of them. */
    private void leave(int row, int bound) {
        side[row] = bound;
        elimination.put(row, false);
        toBound(row);
    }

    /** Takes a row with bounds into the set; a rival of it goes to its bound. */
    private void enter(int row) {
        int rival = takeRivalOut(row);
        if (rival != NeutralRows.NONE) {
            toBound(rival);
        }
        elimination.put(row, true);
    }

    /** Takes a row with bounds into the set; whatever a rival of it carries it goes on carrying. */
    void letIn(int row) {
        takeRivalOut(row);
        elimination.put(row, true);
    }

    /**
     * Takes the row of a joint out of the set that is along the same coordinate as another of its
     * rows; which one that is. A limit and a brake that both hold ask for one speed each: their
     * difference, however small, drove them against each other by 10¹² N·s. Rows that are kept near
     * what they carried share what there is to carry.
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

    /** Takes a row out of the set that is beyond its bounds, or into it. */
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

    /** The impulse within a row's bounds that is nearest to one, N·s. */
    private double within(int row, double impulse) {
        return Math.max(rows.lower[row], Math.min(rows.upper[row], impulse));
    }

    /**
     * What a row is due to carry by its bounds: outside the set the bound, in it what is within.
     */
    double due(int row) {
        double bound = side[row] > 0 ? rows.upper[row] : rows.lower[row];
        return elimination.isIn(row) ? within(row, rows.impulse[row]) : bound;
    }

    /** By how much, in m/s, a row that follows loads is off what it is due to carry. */
    double lag(int row) {
        boolean follows = rows.load[row] != NeutralRows.NONE || rows.twin[row] != NeutralRows.NONE;
        double change = follows ? due(row) - rows.impulse[row] : 0;
        return rows.inMetres(row, change) * rows.response[row];
    }
}
