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
 * The rows of one island, whatever they stand for. A row has up to four bodies with a derivative
 * each, and asks for w = J·v + give·j − target to be 0, or, where its impulse j is at a bound, not
 * to drive it beyond: w ≥ 0 at the lower bound, w ≤ 0 at the upper one.
 */
final class NeutralRows {

    /** Bodies of a row at most. */
    static final int BODIES = 4;

    /** Numbers of the derivatives of a row: along x, along y and turning, of each body. */
    static final int DERIVATIVES = 3 * BODIES;

    static final int NONE = -1;

    /**
     * Give of every row for elimination, as a share of its response: it keeps redundant rows apart,
     * and iteration takes its effect back where the rows agree.
     */
    static final double REGULAR = 1e-11;

    /**
     * Share of a row's response below which what locked axes leave of it is round-off: the square
     * of what a direction is off by that points along the axis.
     */
    private static final double ACROSS = 1e-24;

    int count;

    /** How many bodies a row has, their offsets in the motions, and the derivatives. */
    int[] bodies = new int[32];

    int[] body = new int[32 * BODIES];
    double[] derivative = new double[32 * DERIVATIVES];

    /** N·s, or N·m·s. */
    double[] impulse = new double[32];

    double[] lower = new double[32];
    double[] upper = new double[32];

    /** Speed that the row aims at, m/s or rad/s. */
    double[] target = new double[32];

    /** Speed by which it gives way to a unit impulse, 1/kg. */
    double[] give = new double[32];

    /** Speed that a unit impulse gives the row itself, 1/kg. */
    double[] response = new double[32];

    /**
     * Of a row whose bounds are ± a share of the sum of other rows' impulses: the share, the first
     * of those rows and how many they are. Of a row of a pair within a disc the other one.
     */
    double[] share = new double[32];

    int[] load = new int[32];
    int[] loads = new int[32];
    int[] twin = new int[32];

    /**
     * Which joint of the island a row is of, or which contact, else {@link #NONE}; and which row.
     */
    int[] joint = new int[32];

    int[] contact = new int[32];
    int[] part = new int[32];

    /** What the row keeps from changing as bodies move: an equation's error or a gap, m or rad. */
    double[] place = new double[32];

    /** Whether the place of the row is held when bodies move on, not only its speed. */
    boolean[] holdsPlace = new boolean[32];

    /** The elasticity of an impact, 0 where none rebounds. */
    double[] elasticity = new double[32];

    /**
     * Metres that a unit of the row's coordinate stands for: 1 of a length; of an angle what it
     * moves the outline by, so that a tolerance in m/s is one of any row.
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

    /** Leaves locked axes out; what is left of a row across all that it could move is nothing. */
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

    /** How far those of its bodies reach that it can turn, m; 1 where none has an end. */
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

    /** 1 or −1 where two rows have the same derivatives, or opposite ones; else 0. */
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

    /** What an impulse of one row gives another through a body that both have, 1/kg. */
    double through(int row, int i, int other, int k) {
        return through(derivative, row, i, derivative, other, k);
    }

    /** What a unit impulse of one row gives another, both by derivatives other than their own. */
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

    /** J·x with the columns from one on, of velocities or displacements. */
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

    /** How far a row is from what it asks for, m/s or rad/s. */
    double residual(int row) {
        return speed(row) + give[row] * impulse[row] - target[row];
    }

    /** Adds to a row's impulse, and gives its bodies the change. */
    void push(int row, double change) {
        impulse[row] += change;
        apply(row, change);
    }

    /** Gives a row's bodies an impulse. */
    void apply(int row, double change) {
        move(row, change, VX);
    }

    /** Changes the columns from one on, of velocities or displacements, as an impulse does. */
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

    /** Whether a row is what a point of a contact pushes with. */
    boolean isPoint(int row) {
        return contact[row] != NONE && load[row] == NONE;
    }

    /** Whether a row of a joint only brakes: a motor that is to stand, with bounds. */
    boolean isBrake(int row) {
        boolean isBound = lower[row] < upper[row] && !isEquation(row);
        return joint[row] != NONE && !holdsPlace[row] && target[row] == 0 && isBound;
    }

    /** Writes the bounds of rows that follow from other rows' impulses. */
    void bound() {
        for (int row = 0; row < count; row++) {
            bound(row);
        }
    }

    /** Writes the bounds of one row that follow from another row's impulse. */
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

    /** The impulse that would solve a row alone, without bounds. */
    double wish(int row) {
        return impulse[row] - residual(row) / (response[row] + give[row]);
    }

    static {
        assert VY == VX + 1 && SPIN == VX + 2;
        assert Motions.DY == Motions.DX + 1 && Motions.TURN == Motions.DX + 2;
    }
}
