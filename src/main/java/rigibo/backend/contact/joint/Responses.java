package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Responses of whole groups of joined bodies to an impulse of a row, with the group's equations
 * held: R = M⁻¹·jᵀ − M⁻¹·Jᵀ·K⁻¹·J·M⁻¹·jᵀ, with j the row's derivatives. Velocities are stored group
 * by group, so that a push is one loop over each group that the row acts on.
 */
final class Responses {

    private static final int NONE = -1;

    /**
     * Most bodies of a group that responds as a whole; bodies of a larger one respond as if they
     * were free.
     */
    private static final int MOST_BODIES = 128;

    /**
     * Least response of a row, as a share of that of free bodies. Where joints hold everything that
     * an impulse pushes, the response is nearly 0, and impulses would grow beyond what limits and
     * motors can counter.
     */
    static final double LEAST = 1e-3;

    /**
     * Largest displacement in a second, in widths of the body or of the joint: a tenth of a width
     * in a substep of GAME. With three widths a second, bones that an impact had torn apart by
     * millimetres stayed apart for several steps.
     */
    static final double MOST_MOVED = 24;

    /** Most groups that a row can act on. */
    private static final int SIDES = NeutralRows.BODIES;

    private final Bodies bodies;
    private final Motions motions;
    private final NeutralRows rows;
    private final EquationFactor factor;
    private final EquationList equations;
    private final AssemblyTree tree;

    /** Velocities, three by body; and a stored copy of those of one group. */
    private double[] velocity = new double[64];

    private double[] kept = new double[64];

    /**
     * By entry of the motions: the start of its velocity. By group: the start of those of its
     * bodies.
     */
    private int[] place = new int[16];

    private int[] groupPlace = new int[17];

    /** By body in this order: the reach of its outline, m; 1 if that is 0 or infinite. */
    private double[] reach = new double[16];

    /** By row: the blocks of velocities that it acts on; a block is a group or a single body. */
    private int[] blockA = new int[64];

    private int[] blockB = new int[64];

    /** By row: the value of {@link #steepest}, 0 if it is not computed yet. */
    private double[] steep = new double[64];

    /** By block: the sum of the largest changes of its velocities since they were taken, m/s. */
    private double[] moved = new double[17];

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

    Responses(Bodies bodies, Motions motions, NeutralRows rows, EquationFactor factor) {
        this.bodies = bodies;
        this.motions = motions;
        this.rows = rows;
        this.factor = factor;
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
            blockA = new int[rows.bodies.length];
            blockB = new int[rows.bodies.length];
            steep = new double[rows.bodies.length];
        }
        if (place.length < motions.count) {
            place = new int[motions.slots.length];
            velocity = new double[3 * motions.slots.length];
            kept = new double[3 * motions.slots.length];
            groupPlace = new int[motions.slots.length + 1];
            reach = new double[motions.slots.length];
            moved = new double[motions.slots.length + 1];
        }
        Arrays.fill(isKnown, 0, rows.count, false);
        Arrays.fill(steep, 0, rows.count, 0);
        used = 0;
        int end = 0;
        for (int group = 0; group < tree.groups; group++) {
            groupPlace[group] = end;
            for (int i = tree.bodyStart[group]; i < tree.bodyStart[group + 1]; i++) {
                if (equations.isFirst(tree.bodies[i])) {
                    place[equations.entry[tree.bodies[i]]] = end;
                    end += 3;
                }
            }
        }
        groupPlace[tree.groups] = end;
        for (int entry = 1; entry < motions.count; entry++) {
            if (equations.bodyOfEntry(entry) == NONE) {
                place[entry] = end;
                end += 3;
            }
        }
        for (int entry = 1; entry < motions.count; entry++) {
            double far = motions.reach[entry];
            reach[place[entry] / 3] = far > 0 && far < Double.POSITIVE_INFINITY ? far : 1;
        }
        for (int row = 0; row < rows.count; row++) {
            findBlocks(row);
        }
        take();
    }

    private void findBlocks(int row) {
        int last = row * NeutralRows.BODIES + rows.bodies[row] - 1;
        int none = moved.length - 1;
        blockA[row] = rows.bodies[row] > 0 ? block(rows.body[row * NeutralRows.BODIES]) : none;
        blockB[row] = rows.bodies[row] > 1 ? block(rows.body[last]) : none;
    }

    /** The block of velocities of a body at an offset in the motions. */
    private int block(int offset) {
        int entry = offset / Motions.STRIDE;
        int group = smallGroupOf(entry);
        return (group == NONE ? place[entry] : groupPlace[group]) / 3;
    }

    /** The group of joined bodies that responds as a whole, or {@link #NONE}. */
    private int smallGroupOf(int entry) {
        int body = equations.bodyOfEntry(entry);
        return body == NONE || isLarge(tree.groupOf[body]) ? NONE : tree.groupOf[body];
    }

    /**
     * The sum of the largest changes of velocities in both blocks of a row since they were taken,
     * m/s. A row's speed has changed by no more than this, times how {@link #steepest} it is.
     */
    double moved(int row) {
        return moved[blockA[row]] + moved[blockB[row]];
    }

    /**
     * How much a row's speed changes at most if both of its bodies change theirs by 1 m/s, also at
     * their outlines by turning; infinite for rows of more than two bodies.
     */
    double steepest(int row) {
        if (steep[row] == 0) {
            steep[row] = steepness(row);
        }
        return steep[row];
    }

    private double steepness(int row) {
        double most = rows.bodies[row] > 2 ? Double.POSITIVE_INFINITY : 0;
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.DERIVATIVES + 3 * k;
            int v = place[rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE];
            double moves = Math.abs(rows.derivative[at]) + Math.abs(rows.derivative[at + 1]);
            double turns = Math.abs(rows.derivative[at + 2]) / reach[v / 3];
            most = Math.max(most, moves + turns);
        }
        return most;
    }

    /** Takes the velocities of the motions. */
    void take() {
        Arrays.fill(moved, 0);
        for (int entry = 1; entry < motions.count; entry++) {
            System.arraycopy(
                    motions.data, entry * Motions.STRIDE + Motions.VX, velocity, place[entry], 3);
        }
    }

    /** Whether a group is so large that its bodies respond as if they were free. */
    private boolean isLarge(int group) {
        return tree.bodyStart[group + 1] - tree.bodyStart[group] > MOST_BODIES;
    }

    /** Whether any group is that large, so that its equations have to be solved after each pass. */
    boolean areAnyLarge() {
        for (int group = 0; group < tree.groups; group++) {
            if (isLarge(group)) {
                return true;
            }
        }
        return false;
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

    /** Sets displacements of 0 in place of velocities. */
    void rest() {
        Arrays.fill(velocity, 0, 3 * motions.count, 0);
    }

    /** Stores the displacements of a group's bodies. */
    void keep(int group) {
        int from = groupPlace[group];
        System.arraycopy(velocity, from, kept, from, groupPlace[group + 1] - from);
    }

    /** Restores the stored displacements of a group. */
    void recall(int group) {
        int from = groupPlace[group];
        System.arraycopy(kept, from, velocity, from, groupPlace[group + 1] - from);
    }

    /** Scales the change of a group's displacements since they were stored. */
    void scale(int group, double share) {
        for (int v = groupPlace[group]; v < groupPlace[group + 1]; v++) {
            velocity[v] = kept[v] + share * (velocity[v] - kept[v]);
        }
    }

    /** The largest displacement of a group's outlines since they were stored, m. */
    double farthest(int group) {
        double most = 0;
        for (int i = tree.bodyStart[group]; i < tree.bodyStart[group + 1]; i++) {
            int entry = equations.entry[tree.bodies[i]];
            int v = place[entry];
            double way = Math.abs(velocity[v] - kept[v]) + Math.abs(velocity[v + 1] - kept[v + 1]);
            double turn = Math.abs(velocity[v + 2] - kept[v + 2]);
            most = Math.max(most, turn == 0 ? way : way + motions.reach[entry] * turn);
        }
        return most;
    }

    /**
     * Moves bodies by their displacements in h seconds, scaled down if an outline would move too
     * far: an impulse that joints hold nearly completely would throw other bodies about.
     */
    void move(double h) {
        double most = MOST_MOVED * Math.abs(h);
        double farthest = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int v = place[entry];
            double way =
                    Math.abs(velocity[v])
                            + Math.abs(velocity[v + 1])
                            + motions.reach[entry] * Math.abs(velocity[v + 2]);
            double width = 2 * bodies.boundingRadius[motions.slots[entry]];
            farthest = Math.max(farthest, way / width);
        }
        double share = farthest > most ? most / farthest : 1;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            motions.data[at + Motions.DX] += share * velocity[place[entry]];
            motions.data[at + Motions.DY] += share * velocity[place[entry] + 1];
            motions.data[at + Motions.TURN] += share * velocity[place[entry] + 2];
        }
    }

    /** Adds the displacements of a row's own bodies by an impulse along it, kg·m. */
    void displace(int row, double change) {
        for (int k = 0; k < rows.bodies[row]; k++) {
            int offset = rows.body[row * NeutralRows.BODIES + k];
            int at = row * NeutralRows.DERIVATIVES + 3 * k;
            int to = place[offset / Motions.STRIDE];
            double linear = motions.data[offset + Motions.INVERSE_MASS] * change;
            velocity[to] += linear * rows.derivative[at];
            velocity[to + 1] += linear * rows.derivative[at + 1];
            velocity[to + 2] +=
                    motions.data[offset + Motions.INVERSE_INERTIA]
                            * change
                            * rows.derivative[at + 2];
        }
    }

    /** The residual of a row, m/s or rad/s. */
    double residual(int row) {
        return along(row) + rows.give[row] * rows.impulse[row] - rows.target[row];
    }

    /** J·v, or J·x of displacements. */
    double along(int row) {
        double sum = 0;
        for (int k = 0; k < rows.bodies[row]; k++) {
            int at = row * NeutralRows.DERIVATIVES + 3 * k;
            int v = place[rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE];
            sum +=
                    rows.derivative[at] * velocity[v]
                            + rows.derivative[at + 1] * velocity[v + 1]
                            + rows.derivative[at + 2] * velocity[v + 2];
        }
        return sum;
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
        double[] v = velocity;
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
            int group = smallGroupOf(entry);
            int to = group == NONE ? place[entry] : groupPlace[group];
            if (!isListed(row, side, to)) {
                int count = group == NONE ? 3 : groupPlace[group + 1] - to;
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
            int v = place[rows.body[row * NeutralRows.BODIES + k] / Motions.STRIDE];
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
            double turns = reach[(target[side] + i) / 3] * Math.abs(response[r + 2]);
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
            int to = place[offset / Motions.STRIDE] - target[side];
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
                int to = start[side] + place[offset / Motions.STRIDE] - target[side];
                response[to] += mass * rows.derivative[at];
                response[to + 1] += mass * rows.derivative[at + 1];
                response[to + 2] += inertia * rows.derivative[at + 2];
            }
        }
    }
}
