package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * The rows with bounds in an island whose equations are eliminated: limits, motors, and springs
 * whose force is known. A row within its bounds holds like an equation; a row at a bound is solved
 * in passes (projected Gauss–Seidel). Rows may change between the two during the first passes.
 */
final class BoundedRows {

    private static final int NONE = EquationList.NONE;

    /**
     * Distance from a limit, as a share of the joint's size, up to which a limit that carried load
     * is expected to carry again.
     */
    private static final double CLOSED = 1e-4;

    private final Motions motions;
    private final NeutralRows rows;
    private final JointRows joints;
    private final PackedJoints packed;
    private final EquationList equations;
    private final Responses responses;

    /** All rows with bounds; and by row whether it holds. */
    private int[] bounded = new int[64];

    private int count;
    private int jointRows;
    private boolean[] holds = new boolean[64];

    /** Share of the last kick's impulses with which joints start. */
    private double share;

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

    BoundedRows(
            Motions motions,
            NeutralRows rows,
            JointRows joints,
            PackedJoints packed,
            EquationList equations,
            Responses responses) {
        this.responses = responses;
        this.motions = motions;
        this.rows = rows;
        this.joints = joints;
        this.packed = packed;
        this.equations = equations;
    }

    /** Rows solved since it was asked for last. */
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
        return rows.place[row] <= 0 || rows.place[row] < CLOSED * joints.size(row);
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

    /** Whether there are any. */
    boolean areAny() {
        return count > 0;
    }

    /** Lists contacts as well, whose rows have been written meanwhile. */
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
        for (int i = 0; i < count; i++) {
            int row = bounded[i];
            double further = share * way[row];
            way[row] = further + step[row];
            if (further != 0 && !holds[row]) {
                double change = clamp(row, rows.impulse[row] + further) - rows.impulse[row];
                if (change != 0) {
                    rows.impulse[row] += change;
                    responses.push(row, change);
                }
            }
        }
        squareBefore = square;
    }

    /** Restarts the extrapolation, since other rows hold. */
    void beginWay() {
        squareBefore = 0;
    }

    /**
     * Makes one pass over the rows that do not hold; returns the largest change of a row's speed,
     * m/s.
     */
    double pass(boolean isBack) {
        double most = 0;
        square = 0;
        for (int i = 0; i < count; i++) {
            int row = bounded[isBack ? count - 1 - i : i];
            step[row] = 0;
            if (!holds[row]) {
                most = Math.max(most, solve(row));
            }
        }
        return most;
    }

    private double solve(int row) {
        double residual = responses.residual(row);
        if (residual >= 0 && rows.impulse[row] <= rows.lower[row] && rows.load[row] == NONE) {
            return 0;
        }
        if (rows.upper[row] == 0 && rows.impulse[row] == 0) {
            return 0;
        }
        solves++;
        double response = responses.own(row) + rows.give[row];
        double change = clamp(row, rows.impulse[row] - residual / response) - rows.impulse[row];
        if (change == 0) {
            return 0;
        }
        rows.impulse[row] += change;
        responses.push(row, change);
        step[row] = change;
        square += change * change * responses.own(row);
        return Math.abs(change) * responses.own(row) * reach(row);
    }

    /**
     * Factor that turns a row's speed into one of outlines: the reach of the bodies that it turns,
     * otherwise 1.
     */
    private double reach(int row) {
        double most = 0;
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.DERIVATIVES + 3 * k;
            if (rows.derivative[at] != 0 || rows.derivative[at + 1] != 0) {
                return 1;
            }
            int entry = rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE;
            most = Math.max(most, motions.reach[entry]);
        }
        return most;
    }

    /**
     * Frees rows that are beyond their bounds, and lets rows within them hold if they may. Marks
     * the groups concerned; returns whether there were any.
     */
    boolean exchange(boolean mayEnter, AssemblyTree tree, boolean[] isOther) {
        boolean isAny = false;
        for (int e = 0; e < equations.count; e++) {
            if (equations.boundedCount[e] > 0) {
                boolean isChanged = leave(e);
                if (!isChanged && mayEnter && equations.row[e] == NONE) {
                    isChanged = enter(e);
                }
                if (isChanged) {
                    isAny = true;
                    isOther[tree.groupOf[equations.bodyOf(equations.bodyStart(e))]] = true;
                }
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
        rows.impulse[row] = within;
        holds[row] = false;
        equations.row[e] = NONE;
        return true;
    }

    private boolean enter(int e) {
        for (int i = 0; i < equations.boundedCount[e]; i++) {
            int row = equations.firstBounded[e] + i;
            if (isWithin(row, rows.impulse[row])) {
                enter(e, row);
                return true;
            }
        }
        return false;
    }

    /**
     * Moves bodies back that are visibly beyond limits, by at most a given distance; both are
     * shares of the joints' sizes.
     */
    boolean correct(double most, double seen) {
        boolean isAny = false;
        for (int i = 0; i < count; i++) {
            int row = bounded[i];
            if (rows.holdsPlace[row] && rows.place[row] < 0 && !holds[row]) {
                double size = joints.size(row);
                double off = Math.min(most * size, -rows.place[row]);
                if (off > seen * size) {
                    isAny = true;
                    responses.displace(row, off / rows.response[row]);
                }
            }
        }
        return isAny;
    }
}
