package rigibo.backend.contact.solve;

import static rigibo.backend.contact.row.Motions.INVERSE_MASS;
import static rigibo.backend.contact.row.Motions.VX;
import static rigibo.backend.contact.row.Motions.VY;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * The supports of each body of an island: the contacts below it, by the direction of the island's
 * pull, down to bodies that impulses do not move. Bodies are ordered from the ground up. Each body
 * that is held has a greatest speed of sinking, since all bodies below it can only close their
 * gaps.
 */
final class Supports {

    static final int NONE = -1;

    /** Cosine of the angle to the pull up to which a contact's normal counts as vertical. */
    private static final double STEEPEST = 0.5;

    /**
     * Least distance of points on either side of a body's centre of mass, as a share of its reach,
     * and least sine of the angles of normals on either side of the pull, that hold a body. What
     * stands on less, like a disc on another, gives way sideways when it is struck.
     */
    private static final double BROAD = 0.1;

    /** How far a wedged body's centre of mass may be beside its points, as a share of its reach. */
    private static final double BESIDE = 1e-3;

    /** By entry: speed along the pull at which it can sink at most, m/s; infinite if not held. */
    double[] sinks = new double[16];

    /** Entries from the ground up; only the first {@link #count} are valid. */
    int[] order = new int[16];

    int count;

    private final Bodies bodies;
    private final Motions motions;
    private final PackedContacts contacts;

    /** By entry: first contact below it, first above it. */
    private int[] firstBelow = new int[16];

    private int[] firstAbove = new int[16];

    /** By entry: bodies that move, below it, whose place in the order is not known yet. */
    private int[] waiting = new int[16];

    /** By contact: the next one below the same body, the next one above the same body. */
    private int[] nextBelow = new int[16];

    private int[] nextAbove = new int[16];

    /** By contact: whether A is the upper one of its bodies. */
    private boolean[] isAUpper = new boolean[16];

    /** Direction of the pull. */
    private double downX;

    private double downY;

    Supports(Bodies bodies, Motions motions, PackedContacts contacts) {
        this.bodies = bodies;
        this.motions = motions;
        this.contacts = contacts;
    }

    /**
     * Finds what each body lies on in a substep.
     *
     * @param spare by point: speed at which it may close because of its gap, m/s
     * @return whether anything pulls the island
     */
    boolean find(int substep, double[] spare) {
        reserve();
        count = 0;
        if (!findPull()) {
            return false;
        }
        link(substep);
        order(spare);
        return true;
    }

    /** First contact below a body, {@link #NONE} if there is none. */
    int firstBelow(int entry) {
        return firstBelow[entry];
    }

    /** Next contact below the upper body of a contact. */
    int nextBelow(int row) {
        return nextBelow[row];
    }

    /** Whether A is the upper one of a contact's bodies. */
    boolean isAUpper(int row) {
        return isAUpper[row];
    }

    /** Offset of the lower body of a contact. */
    int lower(int row) {
        return isAUpper[row] ? contacts.bodyB[row] : contacts.bodyA[row];
    }

    /** Whether the body below a contact is held. */
    boolean isHeldBelow(int row) {
        return sinks[lower(row) / Motions.STRIDE] < Double.POSITIVE_INFINITY;
    }

    /**
     * Speed at which the lower body of a contact can move away along its normal at most, m/s, if it
     * is held.
     */
    double givesWay(int row) {
        int lower = lower(row);
        double[] m = motions.data;
        int at = row * PackedContacts.STRIDE;
        double sign = isAUpper[row] ? 1 : -1;
        double nx = sign * contacts.data[at + PackedContacts.NX];
        double ny = sign * contacts.data[at + PackedContacts.NY];
        return m[lower + INVERSE_MASS] == 0
                ? nx * m[lower + VX] + ny * m[lower + VY]
                : sinks[lower / Motions.STRIDE] * (nx * downX + ny * downY);
    }

    private boolean findPull() {
        double x = 0;
        double y = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            x += bodies.accelerationX[motions.slots[entry]];
            y += bodies.accelerationY[motions.slots[entry]];
        }
        double length = Math.sqrt(x * x + y * y);
        downX = x / length;
        downY = y / length;
        return length > 0;
    }

    /** Lists the contacts below and above each body. */
    private void link(int substep) {
        Arrays.fill(firstBelow, 0, motions.count, NONE);
        Arrays.fill(firstAbove, 0, motions.count, NONE);
        Arrays.fill(waiting, 0, motions.count, 0);
        for (int row = 0; row < contacts.count; row++) {
            double steep = down(row);
            isAUpper[row] = steep > 0;
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            int upper = steep > 0 ? a : b;
            boolean isThere = contacts.firstSubstep[row] <= substep;
            if (isThere && Math.abs(steep) >= STEEPEST && isMoved(upper)) {
                int entry = upper / Motions.STRIDE;
                nextBelow[row] = firstBelow[entry];
                firstBelow[entry] = row;
                if (isMoved(lower(row))) {
                    int below = lower(row) / Motions.STRIDE;
                    nextAbove[row] = firstAbove[below];
                    firstAbove[below] = row;
                    waiting[entry]++;
                }
            }
        }
    }

    private boolean isMoved(int at) {
        return motions.data[at + INVERSE_MASS] > 0;
    }

    /** Cosine of the angle between the pull and the normal from A to B. */
    private double down(int row) {
        int at = row * PackedContacts.STRIDE;
        return contacts.data[at + PackedContacts.NX] * downX
                + contacts.data[at + PackedContacts.NY] * downY;
    }

    /** Orders bodies from the ground up. Those that lie on each other in a ring are left out. */
    private void order(double[] spare) {
        Arrays.fill(sinks, 0, motions.count, Double.POSITIVE_INFINITY);
        for (int entry = 0; entry < motions.count; entry++) {
            if (!isMoved(entry * Motions.STRIDE)) {
                sinks[entry] = 0;
            } else if (waiting[entry] == 0) {
                order[count++] = entry;
            }
        }
        for (int i = 0; i < count; i++) {
            sinks[order[i]] = sinks(order[i], spare);
            for (int row = firstAbove[order[i]]; row != NONE; row = nextAbove[row]) {
                int upper = isAUpper[row] ? contacts.bodyA[row] : contacts.bodyB[row];
                if (--waiting[upper / Motions.STRIDE] == 0) {
                    order[count++] = upper / Motions.STRIDE;
                }
            }
        }
    }

    /**
     * Speed at which a body can sink until the first thing below it stops it, m/s; infinite unless
     * it is held on both sides, against falling over and against sliding off.
     */
    private double sinks(int entry, double[] spare) {
        double[] d = contacts.data;
        double least = Double.POSITIVE_INFINITY;
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double leansLeft = Double.POSITIVE_INFINITY;
        double leansRight = Double.NEGATIVE_INFINITY;
        for (int row = firstBelow[entry]; row != NONE; row = nextBelow[row]) {
            if (isHeldBelow(row)) {
                int at = row * PackedContacts.STRIDE;
                double sign = isAUpper[row] ? 1 : -1;
                double steep = sign * down(row);
                double across =
                        sign * d[at + PackedContacts.NX] * downY
                                - sign * d[at + PackedContacts.NY] * downX;
                leansLeft = Math.min(leansLeft, across);
                leansRight = Math.max(leansRight, across);
                for (int point = 0; point < contacts.points[row]; point++) {
                    double may = (givesWay(row) + spare[2 * row + point]) / steep;
                    double lever = leverOfUpper(row, point);
                    least = Math.min(least, may);
                    left = Math.min(left, lever);
                    right = Math.max(right, lever);
                }
            }
        }
        double reach = motions.reach[entry];
        boolean isBroad = !motions.turns || left < -BROAD * reach && right > BROAD * reach;
        boolean isUpright = leansLeft <= BROAD && leansRight >= -BROAD;
        boolean isWedged = leansLeft < -BROAD && leansRight > BROAD;
        boolean isAbove = left <= BESIDE * reach && right >= -BESIDE * reach;
        boolean isHeld = isBroad && isUpright || isWedged && isAbove;
        return isHeld ? least : Double.POSITIVE_INFINITY;
    }

    /** Lever of a point on the upper body, m, about the normal that points down. */
    double leverOfUpper(int row, int point) {
        int at = row * PackedContacts.STRIDE + 2 * point;
        return isAUpper[row]
                ? contacts.data[at + PackedContacts.LEVER_A0]
                : -contacts.data[at + PackedContacts.LEVER_B0];
    }

    /** Lever of a point on the lower body, m, about the normal that points down. */
    double leverOfLower(int row, int point) {
        int at = row * PackedContacts.STRIDE + 2 * point;
        return isAUpper[row]
                ? contacts.data[at + PackedContacts.LEVER_B0]
                : -contacts.data[at + PackedContacts.LEVER_A0];
    }

    private void reserve() {
        if (order.length < motions.count) {
            int capacity = motions.slots.length;
            sinks = new double[capacity];
            order = new int[capacity];
            firstBelow = new int[capacity];
            firstAbove = new int[capacity];
            waiting = new int[capacity];
        }
        if (nextBelow.length < contacts.count) {
            int capacity = contacts.pair.length;
            nextBelow = new int[capacity];
            nextAbove = new int[capacity];
            isAUpper = new boolean[capacity];
        }
    }
}
