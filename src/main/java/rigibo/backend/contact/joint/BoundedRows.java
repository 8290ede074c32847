package rigibo.backend.contact.joint;

import java.util.Arrays;
import java.util.BitSet;

/**
 * The rows with bounds in an island whose equations are eliminated: limits, motors, and springs
 * whose force is known. A row within its bounds holds like an equation. A row at a bound, or one
 * that leaves its bounds, is solved in passes (projected Gauss–Seidel). It holds again from the
 * next kick on if its impulse is within the bounds.
 */
final class BoundedRows {

    private static final int NONE = EquationList.NONE;

    /**
     * Distance from a limit, as a share of the joint's size, up to which a limit that carried load
     * is expected to carry again.
     */
    private static final double CLOSED = 1e-4;

    private final NeutralRows rows;
    private final JointPlaces places;
    private final ContactRows contacts;
    private final PackedJoints packed;
    private final EquationList equations;
    private final Responses responses;
    private final GroupVelocities velocities;
    private final RowMargins margins;

    /** All rows with bounds; and by row, whether it holds. */
    private int[] bounded = new int[64];

    private int count;
    private int jointRows;
    private boolean[] holds = new boolean[64];

    /** Share of the last kick's impulses with which joints start. */
    private double share;

    /** Rows that passes may change: those that do not hold and whose impulse is not fixed. */
    private final BitSet open = new BitSet();

    /** Number of rows with bounds that do not hold. */
    private int released;

    /** Rows that the last pass changed, and rows with a search direction. */
    private final BitSet changed = new BitSet();

    private final BitSet led = new BitSet();

    /** By row: the change of its impulse in the last pass, and the search direction of passes. */
    private double[] step = new double[64];

    private double[] way = new double[64];

    /**
     * Sum of the squares of the last pass's changes, weighted by the responses of the rows; and
     * that of the pass before.
     */
    private double square;

    private double squareBefore;

    private long solves;
    private long asked;

    /** The row that was last tested for sinking in. */
    private int sunk;

    BoundedRows(
            NeutralRows rows,
            JointPlaces places,
            ContactRows contacts,
            PackedJoints packed,
            EquationList equations,
            Responses responses,
            GroupVelocities velocities) {
        this.responses = responses;
        this.velocities = velocities;
        margins = new RowMargins(rows, velocities);
        this.rows = rows;
        this.places = places;
        this.contacts = contacts;
        this.packed = packed;
        this.equations = equations;
    }

    /** Number of rows that passes visited since {@link #beginPasses}. */
    long asked() {
        return asked;
    }

    /** Number of row solutions since the last call. */
    long takeSolves() {
        long sum = solves;
        solves = 0;
        return sum;
    }

    /** Begins with rows that were just listed; those that held in the last kick hold. */
    void begin(double shareOfCarried) {
        share = shareOfCarried;
        if (holds.length < rows.count) {
            holds = new boolean[rows.bodies.length];
            bounded = new int[rows.bodies.length];
        }
        count = 0;
        jointRows = rows.count;
        for (int row = 0; row < rows.count; row++) {
            holds[row] = false;
            if (!rows.isEquation(row)) {
                bounded[count++] = row;
            }
        }
        for (int e = 0; e < equations.count; e++) {
            for (int i = 0; i < equations.boundedCount[e]; i++) {
                int row = equations.firstBounded[e] + i;
                boolean isClosed = !rows.holdsPlace[row] || isClosed(row);
                if (isClosed && equations.row[e] == NONE && isWithin(row, carried(row))) {
                    enter(e, row);
                }
            }
        }
    }

    private boolean isClosed(int row) {
        return rows.place[row] <= 0 || rows.place[row] < CLOSED * places.size(row);
    }

    /** Impulse of a joint's row in the last kick, scaled to the length of this one. */
    double carried(int row) {
        return share * packed.impulseOf(rows.joint[row], rows.part[row]);
    }

    private boolean isWithin(int row, double impulse) {
        return impulse > rows.lower[row] && impulse < rows.upper[row];
    }

    private void enter(int e, int row) {
        equations.row[e] = row;
        holds[row] = true;
    }

    /** Applies the impulses of the last kick. */
    void warm() {
        for (int i = 0; i < count; i++) {
            int row = bounded[i];
            rows.impulse[row] = clamp(row, carried(row));
        }
    }

    private double clamp(int row, double impulse) {
        double lower = rows.lower[row];
        double upper = rows.upper[row];
        return impulse > upper ? upper : impulse < lower ? lower : impulse;
    }

    /** Whether any row has bounds. */
    boolean areAny() {
        return count > 0;
    }

    /** Adds the rows of contacts, which have been written since {@link #begin}. */
    void addContacts() {
        if (holds.length < rows.count) {
            holds = Arrays.copyOf(holds, rows.bodies.length);
            bounded = Arrays.copyOf(bounded, rows.bodies.length);
        }
        if (step.length < rows.count) {
            step = new double[rows.bodies.length];
            way = new double[rows.bodies.length];
        }
        for (int row = jointRows; row < rows.count; row++) {
            bounded[count++] = row;
            holds[row] = false;
            rows.impulse[row] = clamp(row, rows.impulse[row]);
        }
    }

    /** Lets no bounded row hold or carry an impulse. */
    void release() {
        for (int i = 0; i < count; i++) {
            holds[bounded[i]] = false;
            rows.impulse[bounded[i]] = clamp(bounded[i], 0);
        }
        for (int e = 0; e < equations.count; e++) {
            if (equations.boundedCount[e] > 0) {
                equations.row[e] = NONE;
            }
        }
    }

    /**
     * Extrapolates the passes by a nonlinear conjugate gradient, restarted when it does not reduce
     * the change per pass (M. Silcowitz-Hansen, S. Niebe and K. Erleben, A nonsmooth nonlinear
     * conjugate gradient method for interactive contact force problems, 2010). Near the solution,
     * passes alone reduce that change by only a tenth each.
     */
    void accelerate() {
        double share = square < squareBefore ? square / squareBefore : 0;
        led.or(changed);
        for (int row = led.nextSetBit(0); row >= 0; row = led.nextSetBit(row + 1)) {
            double further = share * way[row];
            way[row] = further + (changed.get(row) ? step[row] : 0);
            if (further != 0) {
                lead(row, further);
            }
        }
        squareBefore = square;
    }

    private void lead(int row, double further) {
        double change = clamp(row, rows.impulse[row] + further) - rows.impulse[row];
        if (change != 0) {
            rows.impulse[row] += change;
            responses.push(row, change);
            margins.forget(row);
        }
    }

    /** Begins passes of a kick. */
    void beginPasses() {
        margins.list();
        asked = 0;
        sunk = jointRows;
        beginWay();
    }

    /** Begins passes from velocities and bounds that were just taken. */
    void beginAnew() {
        margins.begin();
        changed.clear();
        open.clear();
        released = 0;
        for (int i = 0; i < count; i++) {
            int row = bounded[i];
            boolean isFixed =
                    rows.lower[row] == rows.upper[row] && rows.impulse[row] == rows.lower[row];
            open.set(row, !holds[row] && !isFixed);
            released += holds[row] ? 0 : 1;
        }
    }

    /** Restarts the extrapolation, since other rows hold. */
    void beginWay() {
        squareBefore = 0;
        for (int row = led.nextSetBit(0); row >= 0; row = led.nextSetBit(row + 1)) {
            way[row] = 0;
        }
        led.clear();
    }

    /**
     * Makes one pass over all rows that do not hold, or only over those that the last pass changed.
     *
     * @param least smallest change of a row's speed that is made, m/s
     * @return the largest change made, m/s
     */
    double pass(boolean isBack, boolean areAll, double least) {
        square = 0;
        BitSet present = areAll ? open : changed;
        asked += areAll ? released : changed.cardinality();
        return isBack ? passBack(present, least) : passForth(present, least);
    }

    private double passForth(BitSet present, double least) {
        double most = 0;
        for (int row = present.nextSetBit(0); row >= 0; row = present.nextSetBit(row + 1)) {
            most = Math.max(most, ask(row, least));
        }
        return most;
    }

    private double passBack(BitSet present, double least) {
        double most = 0;
        int last = present.length() - 1;
        for (int row = last; row >= 0; row = present.previousSetBit(row - 1)) {
            most = Math.max(most, ask(row, least));
        }
        return most;
    }

    /** Solves a row unless its change would be too small; returns the change of its speed, m/s. */
    private double ask(int row, double least) {
        double change = margins.isIdle(row) ? 0 : change(row, least);
        changed.set(row, change != 0);
        return change == 0 ? 0 : make(row, change);
    }

    /** Change of impulse that solves a row; 0 if it is too small to be made. */
    private double change(int row, double least) {
        double residual = velocities.residual(row);
        margins.note(row, residual);
        double impulse = rows.impulse[row];
        boolean mayFall = residual > 0 && impulse > rows.lower[row];
        boolean mayRise = residual < 0 && impulse < rows.upper[row];
        boolean isWithin = impulse >= rows.lower[row] && impulse <= rows.upper[row];
        if (isWithin && (!mayFall && !mayRise || rows.inMetres(row, residual) <= least)) {
            return 0;
        }
        double own = responses.own(row);
        double change = clamp(row, impulse - residual / (own + rows.give[row])) - impulse;
        boolean isWorth = rows.inMetres(row, change) * own > least;
        return isWorth || !isWithin ? change : 0;
    }

    /** Changes a row's impulse; returns the change of the row's speed, m/s. */
    private double make(int row, double change) {
        solves++;
        rows.impulse[row] += change;
        responses.push(row, change);
        step[row] = change;
        double own = responses.own(row);
        square += change * change * own;
        return rows.inMetres(row, change) * own;
    }

    /** Whether any contact point would sink in by more than {@code most} widths in h seconds. */
    boolean areSinking(double h, double most) {
        // A point that sank in before the last pass mostly still does.
        boolean isSinking = sunk < rows.count && isSinking(sunk, h, most);
        for (int row = jointRows; !isSinking && row < rows.count; row++) {
            isSinking = isSinking(row, h, most);
            sunk = row;
        }
        return isSinking;
    }

    private boolean isSinking(int row, double h, double most) {
        return rows.isPoint(row)
                && !margins.isIdle(row)
                && -velocities.residual(row) * h > most * contacts.width(row);
    }

    /**
     * Releases rows that hold with an impulse beyond their bounds, and marks their groups. Returns
     * whether there were any.
     */
    boolean leave(AssemblyTree tree, boolean[] isOther) {
        boolean isAny = false;
        for (int e = 0; e < equations.count; e++) {
            if (equations.boundedCount[e] > 0 && leave(e)) {
                isAny = true;
                isOther[tree.groupOf[equations.bodyOf(equations.bodyStart(e))]] = true;
            }
        }
        return isAny;
    }

    private boolean leave(int e) {
        int row = equations.row[e];
        if (row == NONE) {
            return false;
        }
        double within = clamp(row, rows.impulse[row]);
        if (within == rows.impulse[row]) {
            return false;
        }
        rows.push(row, within - rows.impulse[row]);
        holds[row] = false;
        equations.row[e] = NONE;
        return true;
    }

    /**
     * Moves bodies back that are visibly beyond limits.
     *
     * @param most largest distance, as a share of the joint's size
     * @param seen largest distance that counts as invisible, likewise
     * @return whether any body was moved
     */
    boolean correct(double most, double seen) {
        boolean isAny = false;
        for (int i = 0; i < count; i++) {
            int row = bounded[i];
            if (rows.holdsPlace[row] && rows.place[row] < 0 && !holds[row]) {
                double size = places.size(row);
                double off = Math.min(most * size, -rows.place[row]);
                if (off > seen * size) {
                    isAny = true;
                    velocities.displace(row, off / rows.response[row]);
                }
            }
        }
        return isAny;
    }
}
