package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * Responses of whole groups of joined bodies to an impulse of a row, with the group's equations
 * held: R = M⁻¹·jᵀ − M⁻¹·Jᵀ·K⁻¹·J·M⁻¹·jᵀ, with j the row's derivatives. Velocities are stored group
 * by group, so that a push is one loop over each group that the row acts on.
 */
final class Responses {

    private static final int NONE = EquationList.NONE;

    /**
     * Least response of a row, as a share of that of free bodies. Where joints hold everything that
     * an impulse pushes, the response is nearly 0, and impulses would grow beyond what limits and
     * motors can counter.
     */
    static final double LEAST = 1e-3;

    /** Most groups that a row can act on. */
    private static final int SIDES = NeutralRows.BODIES;

    private final Motions motions;
    private final NeutralRows rows;
    private final EquationFactor factor;
    private final EquationList equations;
    private final AssemblyTree tree;
    private final GroupVelocities velocities;

    /** By row: whether its responses are known; and the row's own response, 1/kg. */
    private boolean[] isKnown = new boolean[64];

    private double[] own = new double[64];

    /**
     * By row and side: the start of its responses, the start of the velocities that they change,
     * and their number.
     */
    private int[] start = new int[64 * SIDES];

    private int[] target = new int[64 * SIDES];
    private int[] length = new int[64 * SIDES];

    /**
     * By row and side: the largest of these responses, 1/kg; an angular one is multiplied by its
     * body's reach.
     */
    private double[] largest = new double[64 * SIDES];

    private double[] response = new double[1024];
    private int used;

    Responses(
            Motions motions, NeutralRows rows, EquationFactor factor, GroupVelocities velocities) {
        this.motions = motions;
        this.rows = rows;
        this.factor = factor;
        this.velocities = velocities;
        equations = factor.equations();
        tree = factor.tree();
    }

    /** Begins with rows that were just written, and with the velocities of the motions. */
    void begin() {
        if (isKnown.length < rows.count) {
            isKnown = new boolean[rows.bodies.length];
            own = new double[rows.bodies.length];
            start = new int[rows.bodies.length * SIDES];
            target = new int[rows.bodies.length * SIDES];
            length = new int[rows.bodies.length * SIDES];
            largest = new double[rows.bodies.length * SIDES];
        }
        Arrays.fill(isKnown, 0, rows.count, false);
        used = 0;
        velocities.begin();
    }

    /** Discards the responses of rows in groups in which other equations hold now. */
    void forget(boolean[] isOther) {
        for (int row = 0; row < rows.count; row++) {
            for (int k = 0; k < rows.bodies[row]; k++) {
                int entry = rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE;
                int body = equations.bodyOfEntry(entry);
                isKnown[row] &= body == NONE || !isOther[tree.groupOf[body]];
            }
        }
    }

    /** Speed that a unit impulse of a row gives the row itself, 1/kg. */
    double own(int row) {
        if (!isKnown[row]) {
            find(row);
        }
        return own[row];
    }

    /** Changes the velocities of all bodies by an impulse of a row. */
    void push(int row, double change) {
        double[] r = response;
        double[] v = velocities.velocity;
        double[] moved = velocities.moved;
        for (int side = row * SIDES; side < (row + 1) * SIDES && length[side] > 0; side++) {
            int from = start[side];
            int to = target[side];
            int count = length[side];
            moved[to / 3] += Math.abs(change) * largest[side];
            for (int i = 0; i < count; i++) {
                v[to + i] += change * r[from + i];
            }
        }
    }

    private void find(int row) {
        int side = row * SIDES;
        Arrays.fill(length, side, side + SIDES, 0);
        for (int k = 0; k < rows.bodies[row]; k++) {
            int entry = rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE;
            int group = velocities.groupOf(entry);
            int to = group == NONE ? velocities.placeOf(entry) : velocities.startOf(group);
            if (!isListed(row, side, to)) {
                int count = group == NONE ? 3 : velocities.endOf(group) - to;
                reserve(count);
                start[side] = used;
                target[side] = to;
                length[side] = count;
                Arrays.fill(response, used, used + count, 0);
                used += count;
                respond(row, side, group);
                largest[side] = largest(side);
                side++;
            }
        }
        double sum = 0;
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.DERIVATIVES + 3 * k;
            int v = velocities.placeOf(rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE);
            for (int s = row * SIDES; s < side; s++) {
                if (v >= target[s] && v < target[s] + length[s]) {
                    int r = start[s] + v - target[s];
                    sum +=
                            rows.derivative[at] * response[r]
                                    + rows.derivative[at + 1] * response[r + 1]
                                    + rows.derivative[at + 2] * response[r + 2];
                }
            }
        }
        own[row] = Math.max(sum, LEAST * rows.response[row]);
        isKnown[row] = true;
    }

    private double largest(int side) {
        double most = 0;
        for (int i = 0; i < length[side]; i += 3) {
            int r = start[side] + i;
            double moves = Math.max(Math.abs(response[r]), Math.abs(response[r + 1]));
            double turns = velocities.reachAt(target[side] + i) * Math.abs(response[r + 2]);
            most = Math.max(most, Math.max(moves, turns));
        }
        return most;
    }

    private boolean isListed(int row, int end, int to) {
        for (int s = row * SIDES; s < end; s++) {
            if (target[s] == to) {
                return true;
            }
        }
        return false;
    }

    private void reserve(int count) {
        if (response.length < used + count) {
            response = Arrays.copyOf(response, 2 * (used + count));
        }
    }

    /** Writes the responses of one group, or of one free body, to a unit impulse of a row. */
    private void respond(int row, int side, int group) {
        if (group != NONE) {
            askNothing(group);
        }
        for (int k = 0; k < rows.bodies[row]; k++) {
            int offset = rows.body[row * NeutralRows.BODIES + k];
            int to = velocities.placeOf(offset / Motions.STRIDE) - target[side];
            if (to >= 0 && to < length[side]) {
                int at = row * NeutralRows.DERIVATIVES + 3 * k;
                double x = motions.data[offset + Motions.INVERSE_MASS] * rows.derivative[at];
                double y = motions.data[offset + Motions.INVERSE_MASS] * rows.derivative[at + 1];
                double turn =
                        motions.data[offset + Motions.INVERSE_INERTIA] * rows.derivative[at + 2];
                response[start[side] + to] += x;
                response[start[side] + to + 1] += y;
                response[start[side] + to + 2] += turn;
                int body = equations.bodyOfEntry(offset / Motions.STRIDE);
                if (group != NONE) {
                    askBack(body, offset, x, y, turn);
                }
            }
        }
        if (group != NONE) {
            factor.solve(group);
            addAnswers(side, group);
        }
    }

    private void askNothing(int group) {
        for (int n = tree.groupStart[group]; n < tree.groupStart[group + 1]; n++) {
            for (int i = tree.start[n]; i < tree.start[n] + tree.own[n]; i++) {
                factor.ask(tree.equation[i], 0);
            }
        }
    }

    /** Asks the equations of a body to remove the change of their speeds by its velocity. */
    private void askBack(int body, int offset, double x, double y, double turn) {
        for (int copy = body; copy != NONE; copy = equations.nextCopy(copy)) {
            askBackCopy(copy, offset, x, y, turn);
        }
    }

    private void askBackCopy(int body, int offset, double x, double y, double turn) {
        for (int i = equations.equationStart(body); i < equations.equationEnd(body); i++) {
            int e = equations.equationOf(i);
            int row = equations.row[e];
            if (row != NONE) {
                double change = 0;
                for (int k = 0; k < rows.bodies[row]; k++) {
                    if (rows.body[row * NeutralRows.BODIES + k] == offset) {
                        int at = row * NeutralRows.DERIVATIVES + 3 * k;
                        change +=
                                rows.derivative[at] * x
                                        + rows.derivative[at + 1] * y
                                        + rows.derivative[at + 2] * turn;
                    }
                }
                factor.ask(e, factor.answer(e) - change);
            }
        }
    }

    private void addAnswers(int side, int group) {
        for (int n = tree.groupStart[group]; n < tree.groupStart[group + 1]; n++) {
            for (int i = tree.start[n]; i < tree.start[n] + tree.own[n]; i++) {
                int row = equations.row[tree.equation[i]];
                if (row != NONE) {
                    addAnswer(side, row, factor.answer(tree.equation[i]));
                }
            }
        }
    }

    private void addAnswer(int side, int row, double impulse) {
        for (int k = 0; k < rows.bodies[row]; k++) {
            int offset = rows.body[row * NeutralRows.BODIES + k];
            double mass = motions.data[offset + Motions.INVERSE_MASS] * impulse;
            double inertia = motions.data[offset + Motions.INVERSE_INERTIA] * impulse;
            if (mass != 0 || inertia != 0) {
                int at = row * NeutralRows.DERIVATIVES + 3 * k;
                int to = start[side] + velocities.placeOf(offset / Motions.STRIDE) - target[side];
                response[to] += mass * rows.derivative[at];
                response[to + 1] += mass * rows.derivative[at + 1];
                response[to + 2] += inertia * rows.derivative[at + 2];
            }
        }
    }
}
