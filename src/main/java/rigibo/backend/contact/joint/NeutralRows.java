package rigibo.backend.contact.joint;

import static rigibo.backend.contact.row.Motions.INVERSE_INERTIA;
import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.SPIN;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

import rigibo.backend.contact.row.LockedAxes;
import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * The rows of one island, of joints and contacts alike. A row has up to four bodies with
 * derivatives J, and asks for w = J·v + give·j − target = 0. If its impulse j is at a bound, it
 * only asks for w ≥ 0 at the lower bound, or w ≤ 0 at the upper one.
 */
final class NeutralRows {

    /** Most bodies of a row. */
    static final int BODIES = 4;

    /** Numbers of the derivatives of a row: along x, along y and turning, of each body. */
    static final int DERIVATIVES = 3 * BODIES;

    static final int NONE = -1;

    /**
     * Compliance of every row in eliminations, as a share of its response. It regularizes redundant
     * rows; refinement removes its effect where rows agree.
     */
    static final double REGULAR = 1e-11;

    /** Share of its own response below which the pivot of a row is round-off. */
    private static final double SINGULAR = 1e-13;

    /**
     * Share of its free response below which a row counts as acting along locked axes alone: the
     * square of the round-off of its direction.
     */
    private static final double ACROSS = 1e-24;

    int count;

    /** By row: the number of its bodies, their offsets in the motions, and the derivatives. */
    int[] bodies = new int[32];

    int[] body = new int[32 * BODIES];
    double[] derivative = new double[32 * DERIVATIVES];

    /** N·s, or N·m·s. */
    double[] impulse = new double[32];

    double[] lower = new double[32];
    double[] upper = new double[32];

    /** Speed that the row aims at, m/s or rad/s. */
    double[] target = new double[32];

    /** Compliance: speed by which the row gives way to a unit impulse, 1/kg. */
    double[] give = new double[32];

    /** Speed that a unit impulse gives the row itself, 1/kg. */
    double[] response = new double[32];

    /**
     * For a row whose bounds are ± a share of the sum of other rows' impulses: the share, the first
     * of these rows, and their number. For a row of a pair within a disc: the other row; the share
     * is then the disc's radius, N·s.
     */
    double[] share = new double[32];

    int[] load = new int[32];
    int[] loads = new int[32];
    int[] twin = new int[32];

    /**
     * The joint or contact of the island that a row belongs to, or {@link #NONE}; and which of its
     * rows it is.
     */
    int[] joint = new int[32];

    int[] contact = new int[32];
    int[] part = new int[32];

    /** Error of an equation, or gap of a limit or contact, m or rad. */
    double[] place = new double[32];

    /** Whether the row holds its place at the end of a drift, not only its speed. */
    boolean[] holdsPlace = new boolean[32];

    /** Elasticity of an impact; 0 if nothing rebounds. */
    double[] elasticity = new double[32];

    /**
     * Metres per unit of the row's coordinate: 1 for a length, the reach of the bodies for an
     * angle. So a tolerance in m/s applies to any row.
     */
    double[] unit = new double[32];

    private final Motions motions;

    /** Axes along which no impulse moves a body, or null where none is locked. */
    private final LockedAxes locks;

    NeutralRows(Motions motions, LockedAxes locks) {
        this.motions = motions;
        this.locks = locks;
    }

    /** Forgets all rows. */
    void clear() {
        count = 0;
    }

    /** A new row without bodies, bounds or target: an equation. */
    int add() {
        if (count == bodies.length) {
            grow(2 * count);
        }
        int row = count++;
        bodies[row] = 0;
        impulse[row] = 0;
        lower[row] = Double.NEGATIVE_INFINITY;
        upper[row] = Double.POSITIVE_INFINITY;
        target[row] = 0;
        give[row] = 0;
        share[row] = 0;
        load[row] = NONE;
        loads[row] = 0;
        twin[row] = NONE;
        joint[row] = NONE;
        contact[row] = NONE;
        part[row] = 0;
        place[row] = 0;
        holdsPlace[row] = false;
        elasticity[row] = 0;
        unit[row] = 1;
        return row;
    }

    private void grow(int capacity) {
        bodies = Arrays.copyOf(bodies, capacity);
        body = Arrays.copyOf(body, capacity * BODIES);
        derivative = Arrays.copyOf(derivative, capacity * DERIVATIVES);
        impulse = Arrays.copyOf(impulse, capacity);
        lower = Arrays.copyOf(lower, capacity);
        upper = Arrays.copyOf(upper, capacity);
        target = Arrays.copyOf(target, capacity);
        give = Arrays.copyOf(give, capacity);
        response = Arrays.copyOf(response, capacity);
        share = Arrays.copyOf(share, capacity);
        load = Arrays.copyOf(load, capacity);
        loads = Arrays.copyOf(loads, capacity);
        twin = Arrays.copyOf(twin, capacity);
        joint = Arrays.copyOf(joint, capacity);
        contact = Arrays.copyOf(contact, capacity);
        part = Arrays.copyOf(part, capacity);
        place = Arrays.copyOf(place, capacity);
        holdsPlace = Arrays.copyOf(holdsPlace, capacity);
        elasticity = Arrays.copyOf(elasticity, capacity);
        unit = Arrays.copyOf(unit, capacity);
    }

    /** Adds a body's derivative to a row; the ground has none. */
    void derive(int row, int offset, double x, double y, double turn) {
        if (offset == 0) {
            return;
        }
        int i = bodies[row]++;
        body[row * BODIES + i] = offset;
        int at = row * DERIVATIVES + 3 * i;
        derivative[at] = x;
        derivative[at + 1] = y;
        derivative[at + 2] = turn;
    }

    /** Ends a row whose derivatives are written. */
    void finish(int row) {
        response[row] = locks == null ? ownResponse(row) : lockedResponse(row);
        unit[row] = isOfAngles(row) ? reach(row) : 1;
    }

    /**
     * Removes locked axes from the derivatives; returns the response that is left, 0 if it is
     * round-off.
     */
    private double lockedResponse(int row) {
        double free = ownResponse(row);
        for (int i = 0; i < bodies[row]; i++) {
            int offset = body[row * BODIES + i];
            int at = row * DERIVATIVES + 3 * i;
            derivative[at] *= locks.freedomX(offset);
            derivative[at + 1] *= locks.freedomY(offset);
        }
        double left = ownResponse(row);
        return left > ACROSS * free ? left : 0;
    }

    private double ownResponse(int row) {
        double sum = 0;
        for (int i = 0; i < bodies[row]; i++) {
            for (int k = 0; k < bodies[row]; k++) {
                if (body[row * BODIES + i] == body[row * BODIES + k]) {
                    sum += through(row, i, row, k);
                }
            }
        }
        return sum;
    }

    private boolean isOfAngles(int row) {
        boolean isTurning = true;
        for (int i = 0; isTurning && i < bodies[row]; i++) {
            int at = row * DERIVATIVES + 3 * i;
            isTurning = derivative[at] == 0 && derivative[at + 1] == 0;
        }
        return isTurning;
    }

    /** Largest reach of a row's bodies that can turn, m; 1 if none has a finite reach. */
    double reach(int row) {
        double most = 0;
        for (int i = 0; i < bodies[row]; i++) {
            int offset = body[row * BODIES + i];
            double reach = motions.reach[offset / Motions.STRIDE];
            boolean turns = motions.data[offset + INVERSE_INERTIA] > 0;
            if (turns && reach < Double.POSITIVE_INFINITY) {
                most = Math.max(most, reach);
            }
        }
        return most > 0 ? most : 1;
    }

    /** 1 if two rows have the same derivatives, −1 if opposite ones, otherwise 0. */
    int parallel(int row, int other) {
        return areAlike(row, other, 1) ? 1 : areAlike(row, other, -1) ? -1 : 0;
    }

    private boolean areAlike(int row, int other, int sign) {
        boolean areAlike = bodies[row] == bodies[other];
        for (int i = 0; areAlike && i < bodies[row]; i++) {
            areAlike = body[row * BODIES + i] == body[other * BODIES + i];
            for (int k = 3 * i; areAlike && k < 3 * i + 3; k++) {
                areAlike =
                        derivative[row * DERIVATIVES + k]
                                == sign * derivative[other * DERIVATIVES + k];
            }
        }
        return areAlike;
    }

    /** A change of a row's coordinate as a length, or of its speed in m/s. */
    double inMetres(int row, double change) {
        return Math.abs(change) * unit[row];
    }

    /** The speed that the impulse of a row alone would give it, m/s. */
    double ownSpeed(int row) {
        return inMetres(row, impulse[row]) * response[row];
    }

    /** Speed that a unit impulse of one row gives another through a body of both, 1/kg. */
    double through(int row, int i, int other, int k) {
        return through(derivative, row, i, derivative, other, k);
    }

    /**
     * Speed along {@code moved} that a unit impulse along {@code pushed} gives through a body of
     * both rows, 1/kg; these stand for the derivatives of the one and of the other row.
     */
    double through(double[] moved, int row, int i, double[] pushed, int other, int k) {
        double[] m = motions.data;
        int offset = body[row * BODIES + i];
        int at = row * DERIVATIVES + 3 * i;
        int to = other * DERIVATIVES + 3 * k;
        return m[offset + INVERSE_MASS] * (moved[at] * pushed[to] + moved[at + 1] * pushed[to + 1])
                + m[offset + INVERSE_INERTIA] * moved[at + 2] * pushed[to + 2];
    }

    /** J·v: how fast the row's coordinate changes, m/s or rad/s. */
    double speed(int row) {
        return along(row, VX);
    }

    /**
     * J·x, with x in three columns of the motions from a given one on: velocities or displacements.
     */
    double along(int row, int column) {
        double[] m = motions.data;
        double sum = 0;
        for (int i = 0; i < bodies[row]; i++) {
            int at = row * DERIVATIVES + 3 * i;
            int offset = body[row * BODIES + i] + column;
            sum +=
                    derivative[at] * m[offset]
                            + derivative[at + 1] * m[offset + 1]
                            + derivative[at + 2] * m[offset + 2];
        }
        return sum;
    }

    /** The pivot of a row in an elimination, with the least magnitude that is not round-off. */
    double pivot(int row, double left) {
        double least = SINGULAR * Math.max(response[row], Double.MIN_NORMAL);
        return Math.abs(left) > least ? left : Math.copySign(least, left);
    }

    /** The residual w of a row, m/s or rad/s. */
    double residual(int row) {
        return speed(row) + give[row] * impulse[row] - target[row];
    }

    /** Adds to a row's impulse and applies the change to its bodies. */
    void push(int row, double change) {
        impulse[row] += change;
        apply(row, change);
    }

    /** Applies an impulse along a row to its bodies. */
    void apply(int row, double change) {
        move(row, change, VX);
    }

    /**
     * Changes three columns of the motions, from a given one on, as an impulse along a row does:
     * velocities or displacements.
     */
    void move(int row, double change, int column) {
        double[] m = motions.data;
        for (int i = 0; i < bodies[row]; i++) {
            int at = row * DERIVATIVES + 3 * i;
            int offset = body[row * BODIES + i];
            double linear = m[offset + INVERSE_MASS] * change;
            m[offset + column] += linear * derivative[at];
            m[offset + column + 1] += linear * derivative[at + 1];
            m[offset + column + 2] += m[offset + INVERSE_INERTIA] * derivative[at + 2] * change;
        }
    }

    /** Whether a row is an equation, which no bound ever frees. */
    boolean isEquation(int row) {
        return lower[row] == Double.NEGATIVE_INFINITY
                && upper[row] == Double.POSITIVE_INFINITY
                && load[row] == NONE
                && twin[row] == NONE;
    }

    /** Whether a row is the normal row of a contact point. */
    boolean isPoint(int row) {
        return contact[row] != NONE && load[row] == NONE;
    }

    /** Whether a row is a brake: a joint's motor with a limited force and a target speed of 0. */
    boolean isBrake(int row) {
        boolean isBound = lower[row] < upper[row] && !isEquation(row);
        return joint[row] != NONE && !holdsPlace[row] && target[row] == 0 && isBound;
    }

    /** Updates all bounds that depend on other rows' impulses. */
    void bound() {
        for (int row = 0; row < count; row++) {
            bound(row);
        }
    }

    /** Updates the bounds of a row, if they depend on other rows' impulses. */
    void bound(int row) {
        if (load[row] != NONE) {
            double sum = 0;
            for (int i = 0; i < loads[row]; i++) {
                sum += impulse[load[row] + i];
            }
            upper[row] = share[row] * Math.max(0, sum);
            lower[row] = -upper[row];
        } else if (twin[row] != NONE) {
            // The disc's nearest point to what both rows would have without it.
            double own = wish(row);
            double other = wish(twin[row]);
            double length = Math.sqrt(own * own + other * other);
            double within = length > share[row] ? Math.abs(own) / length : 1;
            upper[row] = share[row] * within;
            lower[row] = -upper[row];
        }
    }

    /** The impulse that would solve a row alone, without its bounds. */
    double wish(int row) {
        return impulse[row] - residual(row) / (response[row] + give[row]);
    }

    static {
        assert VY == VX + 1 && SPIN == VX + 2;
        assert Motions.DY == Motions.DX + 1 && Motions.TURN == Motions.DX + 2;
    }
}
