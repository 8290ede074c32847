package rigibo.backend.contact.row;

import rigibo.backend.impact.Impact;
import rigibo.backend.storage.IslandWork;
import rigibo.backend.storage.Islands;

import java.util.Arrays;

/**
 * The contacts of one island, packed: {@link #STRIDE} doubles each. A contact is one or two normal
 * rows that are solved together, one friction row and one rolling row. Two points of a flat contact
 * share their tangent line, so that one friction row at their midpoint serves both.
 *
 * <p>With n the normal from A to B and r the arms to the points, the parting speed of point i is
 * n·(vB − vA) + leverB·ωB − leverA·ωA, with lever = r × n.
 */
public final class PackedContacts {

    /*
     * Columns that every pass reads come first, since a cache line holds eight.
     */

    public static final int NX = 0;
    public static final int NY = 1;

    /** Levers r × n of the two points on A and B, m. */
    public static final int LEVER_A0 = 2;

    public static final int LEVER_B0 = 3;
    public static final int LEVER_A1 = 4;
    public static final int LEVER_B1 = 5;

    /** Normal impulses of the two points so far in this kick, N·s. */
    public static final int IMPULSE0 = 6;

    public static final int IMPULSE1 = 7;

    /** Gap of the points when the bodies entered the pile, m. */
    public static final int GAP0 = 8;

    public static final int GAP1 = 9;

    /** Inverse of the matrix {@link #K00}, {@link #K01}, {@link #K11}, kg. */
    public static final int M00 = 10;

    public static final int M01 = 11;
    public static final int M11 = 12;

    /** Compliance: speed at which the contact yields to a unit impulse, 1/kg. */
    public static final int GIVE = 13;

    /** Closing speed of the surfaces that is due to turning and not in the points' speeds, m/s. */
    public static final int NEARING = 14;

    /** Width of the narrower movable body, m; tolerances are shares of it. */
    public static final int WIDTH = 15;

    /** Friction: levers r × t, effective mass in kg, μ, impulse in N·s. */
    public static final int LEVER_TA = 16;

    public static final int LEVER_TB = 17;
    public static final int MASS_T = 18;
    public static final int FRICTION = 19;
    public static final int IMPULSE_T = 20;

    /** Normal impulse of the whole step, N·s. */
    public static final int TOTAL = 21;

    /** Averaged force of the points, N. */
    static final int LOAD0 = 22;

    static final int LOAD1 = 23;

    /** Speed that a unit impulse at point i gives point j, 1/kg. */
    public static final int K00 = 24;

    public static final int K01 = 25;
    public static final int K11 = 26;

    /** Rolling: effective inertia in kg·m², lever in m, angular impulse in N·m·s. */
    public static final int INERTIA_R = 27;

    public static final int ROLLING = 28;
    public static final int IMPULSE_R = 29;

    /** Elasticity, and the closing speed from which on the contact bounces, m/s. */
    public static final int ELASTICITY = 30;

    public static final int BOUNCE_SPEED = 31;

    /** Share of an overlap that is removed per second, 1/s. */
    public static final int RECOVERY = 32;

    /** Normal impulses of the kick before, N·s. */
    static final int BEFORE0 = 33;

    static final int BEFORE1 = 34;

    public static final int STRIDE = 35;

    /**
     * Compliance of every row, as a share of its effective inverse mass. It is too small to be seen
     * but makes the distribution of a load over redundant contacts unique; without it their
     * impulses drift.
     */
    public static final double COMPLIANCE = 1e-10;

    /** Gap of a contact without points, m. What is added to it loses most of its digits. */
    static final double OUT_OF_REACH = 1e9;

    /** Most contacts of one body that count as possibly loaded. */
    static final int LOADED_PER_BODY = 4;

    /** First substep of a contact that existed when the step began. */
    public static final int ALWAYS = -1;

    public double[] data = new double[16 * STRIDE];

    /** By contact: offset of A in {@link Motions}. */
    public int[] bodyA = new int[16];

    /** By contact: offset of B in {@link Motions}. */
    public int[] bodyB = new int[16];

    /** By contact: its pair. */
    public int[] pair = new int[16];

    /** By contact: its number of points, 1 or 2. */
    public int[] points = new int[16];

    /** By contact: the first substep in which it takes part. */
    public int[] firstSubstep = new int[16];

    /** Number of contacts. */
    public int count;

    /** Number of movable bodies of the island. */
    private int bodies;

    /** Tangential speed of B on A that friction aims at, by running surfaces or turning, m/s. */
    public double[] surface = new double[16];

    /** The part of that speed that is due to running surfaces, m/s. */
    public double[] running = new double[16];

    /** Whether a contact was measured again within the substep. */
    public boolean[] isNew = new boolean[16];

    /** Whether any contact has a running surface. */
    public boolean isAnyRunning;

    /** Whether any contact is crushed. */
    public boolean isAnyCrushed;

    /** Last substep in which a contact joins; {@link #ALWAYS} if none does. */
    public int lastJoining;

    /**
     * Contacts from here on are with immovable bodies. Every pass takes them last, so that the
     * error it leaves is between movable bodies, and none sinks into the floor.
     */
    public int groundStart;

    /** By colour: the end of its contacts. No two of one colour share a body that moves. */
    public int[] colourEnd = new int[16];

    /** Number of colours. */
    public int colours;

    /** Colours from here on are of contacts with immovable bodies. */
    public int groundColour;

    /** Number of impacts that were resolved at these contacts. */
    public int impacts;

    /** Work counters of this island and those solved before it. */
    public final IslandWork work = new IslandWork();

    /**
     * Adds a point of a contact to an impact; the levers along normal and tangent give its arms.
     */
    public void addPoint(int row, int point, Impact impact) {
        int at = row * STRIDE;
        int i = impact.points++;
        double nx = data[at + NX];
        double ny = data[at + NY];
        double acrossA = data[at + 2 * point + LEVER_A0];
        double acrossB = data[at + 2 * point + LEVER_B0];
        double alongA = data[at + LEVER_TA];
        double alongB = data[at + LEVER_TB];
        impact.armAX[i] = acrossA * ny + alongA * nx;
        impact.armAY[i] = -acrossA * nx + alongA * ny;
        impact.armBX[i] = acrossB * ny + alongB * nx;
        impact.armBY[i] = -acrossB * nx + alongB * ny;
    }

    /** The smaller width of the two bodies of a contact, m. */
    public double width(int row) {
        return data[row * STRIDE + WIDTH];
    }

    /** Whether a contact has no point. */
    public boolean isOutOfReach(int row) {
        return data[row * STRIDE + GAP0] > OUT_OF_REACH / 2;
    }

    /**
     * Whether a number of contacts is too large for elimination. Only {@link #LOADED_PER_BODY} of
     * them are counted per movable body: it has three unknowns, and most contacts carry nothing.
     */
    private static boolean areCrowd(int contacts, int bodies) {
        int loaded = Math.min(contacts, LOADED_PER_BODY * bodies);
        return loaded * SingleRows.ROWS_PER_CONTACT > SingleRows.MOST_ELIMINATED;
    }

    /** Whether an island that is not packed yet has too many contacts for elimination. */
    public static boolean areCrowd(Islands islands, int island) {
        int contacts = islands.pairStart[island + 1] - islands.pairStart[island];
        int bodies = islands.bodyStart[island + 1] - islands.bodyStart[island];
        return areCrowd(contacts, bodies);
    }

    /** Whether the packed contacts are too many for elimination. */
    public boolean areCrowd() {
        return areCrowd(count, bodies);
    }

    /** Whether the island floats: it has no contact with an immovable body. */
    public boolean areFloating() {
        return groundStart == count;
    }

    /** Largest share of contacts that carry load in a pile where each body stands on two others. */
    public double shareLoaded() {
        return Math.min(1, 2.0 * bodies / count);
    }

    /** Largest change of speed that any contact's impulse causes, m/s. */
    public double strongestAnswer() {
        double most = 0;
        for (int at = 0; at < count * STRIDE; at += STRIDE) {
            most = Math.max(most, (data[at + IMPULSE0] + data[at + IMPULSE1]) * data[at + K00]);
        }
        return most;
    }

    /** Largest of the contacts' widths, m. */
    public double widest() {
        double most = 0;
        for (int at = 0; at < count * STRIDE; at += STRIDE) {
            most = Math.max(most, data[at + WIDTH]);
        }
        return most;
    }

    /** The highest elasticity of any contact. */
    public double highestElasticity() {
        double most = 0;
        for (int at = 0; at < count * STRIDE; at += STRIDE) {
            most = Math.max(most, data[at + ELASTICITY]);
        }
        return most;
    }

    /** Whether a point carries an impulse in this kick or did in the last one. */
    public boolean carries(int row, int point) {
        int at = row * STRIDE + point;
        return data[at + IMPULSE0] > 0 || data[at + BEFORE0] > 0;
    }

    /** Sets all impulses of a contact to 0. */
    public void unload(int row) {
        int at = row * STRIDE;
        data[at + IMPULSE0] = 0;
        data[at + IMPULSE1] = 0;
        data[at + IMPULSE_T] = 0;
        data[at + IMPULSE_R] = 0;
    }

    /** Scales the impulses of a contact. */
    public void scaleImpulses(int row, double share) {
        int at = row * STRIDE;
        data[at + IMPULSE0] *= share;
        data[at + IMPULSE1] *= share;
        data[at + IMPULSE_T] *= share;
        data[at + IMPULSE_R] *= share;
    }

    /** Lets a contact take part only from a substep on. */
    public void joinsIn(int row, int substep) {
        unload(row);
        firstSubstep[row] = substep;
        lastJoining = Math.max(lastJoining, substep);
    }

    /** Removes all contacts, for an island of a number of bodies. */
    void clear(int bodies) {
        this.bodies = bodies;
        count = 0;
        impacts = 0;
        isAnyRunning = false;
        isAnyCrushed = false;
        lastJoining = ALWAYS;
        colours = 0;
    }

    /** Ends a colour: contacts that are added from now on belong to others. */
    void endColour() {
        if (colours == colourEnd.length) {
            colourEnd = Arrays.copyOf(colourEnd, 2 * colours);
        }
        colourEnd[colours++] = count;
    }

    /** Sets all impulses of all contacts to 0. */
    public void unload() {
        for (int row = 0; row < count; row++) {
            unload(row);
        }
    }

    /** Adds a multiple of this kick's impulses to the totals of the step. */
    public void addUpImpulses(int kicks) {
        for (int row = 0; row < count; row++) {
            addUpImpulses(row, kicks);
        }
    }

    /** Adds a multiple of one contact's impulses to its total. */
    public void addUpImpulses(int row, int kicks) {
        int at = row * STRIDE;
        data[at + TOTAL] += kicks * (data[at + IMPULSE0] + data[at + IMPULSE1]);
    }

    /** Adds a contact whose numbers are all 0 and returns its index. */
    int add() {
        if (count == pair.length) {
            int capacity = 2 * count;
            data = Arrays.copyOf(data, capacity * STRIDE);
            bodyA = Arrays.copyOf(bodyA, capacity);
            bodyB = Arrays.copyOf(bodyB, capacity);
            pair = Arrays.copyOf(pair, capacity);
            surface = Arrays.copyOf(surface, capacity);
            running = Arrays.copyOf(running, capacity);
            points = Arrays.copyOf(points, capacity);
            firstSubstep = Arrays.copyOf(firstSubstep, capacity);
            isNew = Arrays.copyOf(isNew, capacity);
        }
        Arrays.fill(data, count * STRIDE, (count + 1) * STRIDE, 0);
        firstSubstep[count] = ALWAYS;
        surface[count] = 0;
        running[count] = 0;
        return count++;
    }

    /** Sum of the normal impulses of all contacts since the step began, N·s. */
    public double totalImpulse() {
        double sum = 0;
        for (int row = 0; row < count; row++) {
            sum += data[row * STRIDE + TOTAL];
        }
        return sum;
    }
}
