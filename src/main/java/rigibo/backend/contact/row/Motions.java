package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * The bodies of one island, packed: eight doubles, one cache line, per body. Entry 0 is the ground,
 * which stands for every body that does not move.
 */
public final class Motions {

    /** Doubles per body, and where each quantity sits. */
    public static final int STRIDE = 8;

    public static final int VX = 0;
    public static final int VY = 1;
    public static final int SPIN = 2;

    /** Moved and turned since the body entered the pile, m and rad. */
    public static final int DX = 3;

    public static final int DY = 4;
    public static final int TURN = 5;
    public static final int INVERSE_MASS = 6;
    public static final int INVERSE_INERTIA = 7;

    /** Bodies up to which what each of them does is followed. */
    static final int FEW = 4;

    private static final int NOBODY = -1;

    public double[] data = new double[16 * STRIDE];

    /** The slot of each entry. */
    public int[] slots = new int[16];

    /** How far the outline of each entry reaches from its centre, m; 0 where nothing turns. */
    public double[] reach = new double[16];

    public int count;

    /** Velocity in m/s of the frame that all velocities and displacements refer to. */
    double frameX;

    double frameY;

    /**
     * Whether what each of them does is followed however many they are: joints hold them together,
     * and their contacts are few.
     */
    public boolean areFollowed;

    /** Whether any of them moves as it is told. */
    public boolean isAnyDriven;

    /** Whether bodies turn: where none does, every spin and turn is 0 and is not looked at. */
    public final boolean turns;

    /** For each slot its entry, valid only where that entry names the slot. */
    private int[] entries = new int[16];

    public Motions(boolean turns) {
        this.turns = turns;
    }

    /** Lets what is packed from now on be relative to what moves at a velocity, m/s. */
    void takeFrame(double velocityX, double velocityY) {
        frameX = velocityX;
        frameY = velocityY;
    }

    /** Whether velocities are what they are for the world. */
    boolean isInWorld() {
        return frameX == 0 && frameY == 0;
    }

    /** Empties the pack but for the ground. */
    void clear(Bodies bodies) {
        if (entries.length < bodies.type.length) {
            entries = new int[bodies.type.length];
        }
        count = 1;
        isAnyDriven = false;
        slots[0] = NOBODY;
        Arrays.fill(data, 0, STRIDE, 0);
    }

    /** The offset of a body's entry; packs the body first if it moves and is not there yet. */
    int offset(Bodies bodies, int slot) {
        int entry = entries[slot];
        if (entry < count && slots[entry] == slot) {
            return entry * STRIDE;
        }
        return bodies.isMoved(slot) ? pack(bodies, slot) : 0;
    }

    /** As one that does not turn: where bodies do, {@link PackedTurns} writes how. */
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

    /** Whether bodies are so few that the motion of each one is seen, or are followed anyway. */
    public boolean areFew() {
        return areFollowed || count <= FEW + 1;
    }

    /**
     * World x in m of the centre of mass of a packed body, at an offset, some seconds ahead: at a
     * time in s after the step's start.
     */
    public double x(Bodies bodies, int at, double ahead, double time) {
        double inFrame = bodies.x[slots[at / STRIDE]] + data[at + DX] + ahead * data[at + VX];
        return inFrame + time * frameX;
    }

    /** The same upwards. */
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

    /** Takes all speed from every entry. */
    public void halt() {
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            halt(at);
        }
    }

    /** Takes all speed from one entry, at its offset. */
    public void halt(int at) {
        Arrays.fill(data, at, at + DX, 0);
    }

    /** How far in m the outline of a body may have come from where it was packed. */
    double moved(int at) {
        double turned = turns ? reach[at / STRIDE] * Math.abs(data[at + TURN]) : 0;
        return Math.abs(data[at + DX]) + Math.abs(data[at + DY]) + turned;
    }

    /** The gap of a contact now, m: that of the nearer of its points, negative in overlap. */
    double gap(PackedContacts contacts, int row) {
        double gap = gap(contacts, row, 0);
        return contacts.points[row] == 2 ? Math.min(gap, gap(contacts, row, 1)) : gap;
    }

    /** The gap of a contact's point now, m, negative in overlap. */
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

    /** Speed in m/s at which a contact's point parts; negative when it closes. */
    public double parting(PackedContacts contacts, int row, int point) {
        return parting(data, contacts, row, point);
    }

    /** How fast a point parts by velocities that are laid out as the motions, m/s. */
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
     * How fast a point of B slides along one of A, each so far along the normal from its body's
     * centre, m/s.
     */
    double slide(PackedContacts contacts, int row, double armA, double armB) {
        return along(contacts, row, armA, armB, VX, VY, SPIN);
    }

    /** How far it has slid since the step began, m. */
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

    /** The highest speed along an axis, m/s, of what can be moved and what is driven. */
    public double fastest() {
        double most = 0;
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            most = Math.max(most, Math.max(Math.abs(data[at + VX]), Math.abs(data[at + VY])));
        }
        return most;
    }

    /** Moves all that can be moved by as much, m. */
    public void moveAll(double x, double y) {
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            if (data[at + INVERSE_MASS] > 0) {
                data[at + DX] += x;
                data[at + DY] += y;
            }
        }
    }

    /** The energy of motion at velocities laid out as the motions, of what can be moved, J. */
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

    /** kg of all that can be moved. */
    public double mass() {
        double sum = 0;
        for (int at = STRIDE; at < count * STRIDE; at += STRIDE) {
            sum += data[at + INVERSE_MASS] > 0 ? 1 / data[at + INVERSE_MASS] : 0;
        }
        return sum;
    }

    /**
     * How many times the lightest of what can be moved the heaviest weighs, 1 where nothing can.
     */
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
     * What a unit impulse along one row between A and B, with its levers, gives another with the
     * same direction, 1/kg.
     */
    public double response(
            int a, int b, double leverA, double leverB, double otherA, double otherB) {
        return data[a + INVERSE_MASS]
                + data[b + INVERSE_MASS]
                + data[a + INVERSE_INERTIA] * leverA * otherA
                + data[b + INVERSE_INERTIA] * leverB * otherB;
    }
}
