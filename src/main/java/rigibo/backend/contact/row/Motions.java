package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * The bodies of one island, packed: eight doubles per body, one cache line. Entry 0 is the ground,
 * which stands for all bodies that do not move.
 */
public final class Motions {

    /** Doubles per body; the constants below are the places of the quantities. */
    public static final int STRIDE = 8;

    public static final int VX = 0;
    public static final int VY = 1;
    public static final int SPIN = 2;

    /** Displacement since the body entered the pile, m and, for {@link #TURN}, rad. */
    public static final int DX = 3;

    public static final int DY = 4;
    public static final int TURN = 5;
    public static final int INVERSE_MASS = 6;
    public static final int INVERSE_INERTIA = 7;

    /** Most bodies of an island in which the motion of each body is followed closely. */
    static final int FEW = 4;

    private static final int NOBODY = -1;

    public double[] data = new double[16 * STRIDE];

    /** The slot of each entry. */
    public int[] slots = new int[16];

    /** By entry: radius of its outline about the centre of mass, m; 0 without rotation. */
    public double[] reach = new double[16];

    public int count;

    /** Velocity of the frame of all velocities and displacements, m/s. */
    double frameX;

    double frameY;

    /**
     * Whether the motion of each body is followed closely however many there are: for islands with
     * joints and few contacts.
     */
    public boolean areFollowed;

    /** Whether any packed body is driven. */
    public boolean isAnyDriven;

    /** Whether bodies turn; if not, all spins and turns are 0 and are not read. */
    public final boolean turns;

    /** By slot: its entry, valid only if that entry names the slot. */
    private int[] entries = new int[16];

    public Motions(boolean turns) {
        this.turns = turns;
    }

    /** Sets the frame of bodies packed from now on to one that moves at a velocity, m/s. */
    void takeFrame(double velocityX, double velocityY) {
        frameX = velocityX;
        frameY = velocityY;
    }

    /** Whether the frame is that of the world. */
    boolean isInWorld() {
        return frameX == 0 && frameY == 0;
    }

    /** Removes all entries but the ground. */
    void clear(Bodies bodies) {
        if (entries.length < bodies.type.length) {
            entries = new int[bodies.type.length];
        }
        count = 1;
        isAnyDriven = false;
        slots[0] = NOBODY;
        Arrays.fill(data, 0, STRIDE, 0);
    }

    /** Offset of a body's entry; packs the body first if it moves and is not packed yet. */
    int offset(Bodies bodies, int slot) {
        int entry = entries[slot];
        if (entry < count && slots[entry] == slot) {
            return entry * STRIDE;
        }
        return bodies.isMoved(slot) ? pack(bodies, slot) : 0;
    }

    /** Packs a body without its turning, which {@link PackedTurns} adds. */
    private int pack(Bodies bodies, int slot) {
        if (count == slots.length) {
            slots = Arrays.copyOf(slots, 2 * count);
            reach = Arrays.copyOf(reach, 2 * count);
            data = Arrays.copyOf(data, 2 * count * STRIDE);
        }
        isAnyDriven |= bodies.isDriven(slot);
        slots[count] = slot;
        reach[count] = turns ? bodies.boundingRadius[slot] : 0;
        entries[slot] = count;
        int at = count++ * STRIDE;
        data[at + VX] = bodies.velocityX[slot];
        data[at + VY] = bodies.velocityY[slot];
        data[at + SPIN] = 0;
        data[at + DX] = 0;
        data[at + DY] = 0;
        data[at + TURN] = 0;
        data[at + INVERSE_MASS] = bodies.inverseMass[slot];
        data[at + INVERSE_INERTIA] = 0;
        return at;
    }

    /** Whether the motion of each body is followed closely. */
    public boolean areFew() {
        return areFollowed || count <= FEW + 1;
    }

    /**
     * Predicted world x of the centre of mass of the body at an offset, m: {@code ahead} seconds
     * from now, at a time in s after the step's start.
     */
    public double x(Bodies bodies, int at, double ahead, double time) {
        double inFrame = bodies.x[slots[at / STRIDE]] + data[at + DX] + ahead * data[at + VX];
        return inFrame + time * frameX;
    }

    /**
     * Predicted world y of the centre of mass of the body at an offset, m, as {@link #x} gives x.
     */
    public double y(Bodies bodies, int at, double ahead, double time) {
        double inFrame = bodies.y[slots[at / STRIDE]] + data[at + DY] + ahead * data[at + VY];
        return inFrame + time * frameY;
    }

    /** Moves every entry along its velocity for h seconds. */
    public void drift(double h) {
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            drift(at, h);
        }
    }

    /** Moves one entry, at its offset, along its velocity for h seconds. */
    public void drift(int at, double h) {
        data[at + DX] += h * data[at + VX];
        data[at + DY] += h * data[at + VY];
        if (turns) {
            data[at + TURN] += h * data[at + SPIN];
        }
    }

    /** Sets the velocities of all entries to 0. */
    public void halt() {
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            halt(at);
        }
    }

    /** Sets the velocities of the entry at an offset to 0. */
    public void halt(int at) {
        Arrays.fill(data, at, at + DX, 0);
    }

    /** Upper bound on the displacement of a body's outline since it was packed, m. */
    double moved(int at) {
        double turned = turns ? reach[at / STRIDE] * Math.abs(data[at + TURN]) : 0;
        return Math.abs(data[at + DX]) + Math.abs(data[at + DY]) + turned;
    }

    /** Present gap of a contact, m: that of its nearer point, negative in overlap. */
    public double gap(PackedContacts contacts, int row) {
        double gap = gap(contacts, row, 0);
        return contacts.points[row] == 2 ? Math.min(gap, gap(contacts, row, 1)) : gap;
    }

    /** Present gap of a contact's point, m, negative in overlap. */
    public double gap(PackedContacts contacts, int row, int point) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double gap =
                d[at + PackedContacts.GAP0 + point]
                        + d[at + PackedContacts.NX] * (data[b + DX] - data[a + DX])
                        + d[at + PackedContacts.NY] * (data[b + DY] - data[a + DY]);
        return turns
                ? gap
                        + d[at + 2 * point + PackedContacts.LEVER_B0] * data[b + TURN]
                        - d[at + 2 * point + PackedContacts.LEVER_A0] * data[a + TURN]
                : gap;
    }

    /** Whether no body has been moved since they were packed. */
    public boolean areWhereTheyWere() {
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            if (data[at + DX] != 0 || data[at + DY] != 0 || data[at + TURN] != 0) {
                return false;
            }
        }
        return true;
    }

    /** Parting speed of a contact's point, m/s; negative when it closes. */
    public double parting(PackedContacts contacts, int row, int point) {
        return parting(data, contacts, row, point);
    }

    /** Parting speed of a point at velocities laid out as the motions, m/s. */
    double parting(double[] m, PackedContacts contacts, int row, int point) {
        double[] d = contacts.data;
        int at = row * PackedContacts.STRIDE;
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        double speed =
                d[at + PackedContacts.NX] * (m[b + VX] - m[a + VX])
                        + d[at + PackedContacts.NY] * (m[b + VY] - m[a + VY]);
        return turns
                ? speed
                        + d[at + 2 * point + PackedContacts.LEVER_B0] * m[b + SPIN]
                        - d[at + 2 * point + PackedContacts.LEVER_A0] * m[a + SPIN]
                : speed;
    }

    /**
     * Sliding speed of a point of B along a point of A, m/s; the arms are their positions along the
     * normal from their bodies' centres of mass, m.
     */
    double slide(PackedContacts contacts, int row, double armA, double armB) {
        return along(contacts, row, armA, armB, VX, VY, SPIN);
    }

    /** Distance that such a point has slid since the step began, m. */
    double slid(PackedContacts contacts, int row, double armA, double armB) {
        return along(contacts, row, armA, armB, DX, DY, TURN);
    }

    private double along(
            PackedContacts contacts, int row, double armA, double armB, int x, int y, int turn) {
        double nx = contacts.data[row * PackedContacts.STRIDE + PackedContacts.NX];
        double ny = contacts.data[row * PackedContacts.STRIDE + PackedContacts.NY];
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        return nx * (data[b + y] - data[a + y])
                - ny * (data[b + x] - data[a + x])
                + armB * data[b + turn]
                - armA * data[a + turn];
    }

    /** Highest speed along an axis of all packed bodies, m/s. */
    public double fastest() {
        double most = 0;
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            most = Math.max(most, Math.max(Math.abs(data[at + VX]), Math.abs(data[at + VY])));
        }
        return most;
    }

    /** Moves all movable bodies by the same displacement, m. */
    public void moveAll(double x, double y) {
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            if (data[at + INVERSE_MASS] > 0) {
                data[at + DX] += x;
                data[at + DY] += y;
            }
        }
    }

    /** Kinetic energy of all movable bodies at velocities laid out as the motions, J. */
    public double energy(double[] m) {
        double sum = 0;
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            sum += energy(m, at);
        }
        return sum;
    }

    private double energy(double[] m, int at) {
        double square = m[at + VX] * m[at + VX] + m[at + VY] * m[at + VY];
        double turning = m[at + SPIN] * m[at + SPIN];
        double moving = data[at + INVERSE_MASS] > 0 ? square / data[at + INVERSE_MASS] : 0;
        return (data[at + INVERSE_INERTIA] > 0
                        ? moving + turning / data[at + INVERSE_INERTIA]
                        : moving)
                / 2;
    }

    /** Mass of all movable bodies, kg. */
    public double mass() {
        double sum = 0;
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            sum += data[at + INVERSE_MASS] > 0 ? 1 / data[at + INVERSE_MASS] : 0;
        }
        return sum;
    }

    /** Ratio of the largest mass of a movable body to the smallest; 1 if there is none. */
    public double massRatio() {
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            double inverse = data[at + INVERSE_MASS];
            most = Math.max(most, inverse);
            least = inverse > 0 ? Math.min(least, inverse) : least;
        }
        return most > 0 ? most / least : 1;
    }

    /**
     * Speed that a unit impulse along one row between A and B gives another row with the same
     * direction, 1/kg; rows differ in their levers.
     */
    public double response(
            int a, int b, double leverA, double leverB, double otherA, double otherB) {
        return data[a + INVERSE_MASS]
                + data[b + INVERSE_MASS]
                + data[a + INVERSE_INERTIA] * leverA * otherA
                + data[b + INVERSE_INERTIA] * leverB * otherB;
    }
}
