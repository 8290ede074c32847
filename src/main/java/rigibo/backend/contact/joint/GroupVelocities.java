package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Velocities of an island's bodies, or displacements in their place, stored group by group of
 * joined bodies. A block is a group whose bodies respond together, or a single other body.
 */
final class GroupVelocities {

    private static final int NONE = EquationList.NONE;

    /**
     * Most bodies of a group that responds as a whole; bodies of a larger one respond as if they
     * were free.
     */
    private static final int MOST_BODIES = 128;

    /**
     * Largest displacement in a second, in widths of the body or of the joint: a tenth of a width
     * in a substep of GAME. With three widths a second, bones that an impact had torn apart by
     * millimetres stayed apart for several steps.
     */
    static final double MOST_MOVED = 24;

    private final Bodies bodies;
    private final Motions motions;
    private final NeutralRows rows;
    private final EquationList equations;
    private final AssemblyTree tree;

    /** Velocities, three by body; and a stored copy of those of one group. */
    double[] velocity = new double[64];

    private double[] kept = new double[64];

    /** By entry of the motions: the start of its velocity. By group: that of its first body. */
    private int[] place = new int[16];

    private int[] groupPlace = new int[17];

    /** By body in this order: the reach of its outline, m; 1 if that is 0 or infinite. */
    private double[] reach = new double[16];

    /**
     * By block, numbered by its first body in this order: the sum of the largest changes of its
     * velocities since they were taken, m/s. The last number belongs to no block.
     */
    double[] moved = new double[17];

    GroupVelocities(Bodies bodies, Motions motions, NeutralRows rows, EquationFactor factor) {
        this.bodies = bodies;
        this.motions = motions;
        this.rows = rows;
        equations = factor.equations();
        tree = factor.tree();
    }

    /** Begins with groups that were just laid out, and with the velocities of the motions. */
    void begin() {
        if (place.length < motions.count) {
            place = new int[motions.slots.length];
            velocity = new double[3 * motions.slots.length];
            kept = new double[3 * motions.slots.length];
            groupPlace = new int[motions.slots.length + 1];
            reach = new double[motions.slots.length];
            moved = new double[motions.slots.length + 1];
        }
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
        take();
    }

    /** Takes the velocities of the motions. */
    void take() {
        Arrays.fill(moved, 0);
        for (int entry = 1; entry < motions.count; entry++) {
            System.arraycopy(
                    motions.data, entry * Motions.STRIDE + Motions.VX, velocity, place[entry], 3);
        }
    }

    /** The start of the velocity of an entry of the motions. */
    int placeOf(int entry) {
        return place[entry];
    }

    /** The reach of the outline whose velocity starts there, m; 1 if that is 0 or infinite. */
    double reachAt(int start) {
        return reach[start / 3];
    }

    /** The start of the velocities of a group. */
    int startOf(int group) {
        return groupPlace[group];
    }

    /** The end of the velocities of a group. */
    int endOf(int group) {
        return groupPlace[group + 1];
    }

    /** The group of joined bodies that responds as a whole, or {@link #NONE}. */
    int groupOf(int entry) {
        int body = equations.bodyOfEntry(entry);
        return body == NONE || isLarge(tree.groupOf[body]) ? NONE : tree.groupOf[body];
    }

    /** The block of a body at an offset in the motions. */
    int block(int offset) {
        int entry = offset / Motions.STRIDE;
        int group = groupOf(entry);
        return (group == NONE ? place[entry] : groupPlace[group]) / 3;
    }

    /** The number of no block. */
    int noBlock() {
        return moved.length - 1;
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
}
