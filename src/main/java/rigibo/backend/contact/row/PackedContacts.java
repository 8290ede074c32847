package rigibo.backend.contact.row;

import rigibo.backend.impact.Impact;
import rigibo.backend.storage.IslandWork;
import rigibo.backend.storage.Islands;

import java.util.Arrays;

/**
 * The contacts of one island, packed: {@link #STRIDE} doubles each. A contact is one or two normal
 * rows that are solved together, one friction row and one rolling row; two points of a flat contact
 * share their tangent line, so one friction row at their middle does for both.
 *
 * <p>With n the normal from A to B and r the arms to the points, the speed at which point i parts
 * is n·(vB − vA) + leverB·ωB − leverA·ωA, lever = r × n.
 */
public final class PackedContacts {

    /*
     * What every pass reads stands first, and what only some do behind it: a cache line holds eight.
     */

    public static final int NX = 0;
    public static final int NY = 1;

    /** Levers r × n of the two points on A and B, m. */
    public static final int LEVER_A0 = 2;

    public static final int LEVER_B0 = 3;
    public static final int LEVER_A1 = 4;
    public static final int LEVER_B1 = 5;

    /** Impulses so far in this kick, N·s. */
    public static final int IMPULSE0 = 6;

    public static final int IMPULSE1 = 7;

    /** Gap of the points when the bodies entered the pile, m. */
    public static final int GAP0 = 8;

    public static final int GAP1 = 9;

    /** The inverse of {@link #K00}, {@link #K01}, {@link #K11}, kg. */
    public static final int M00 = 10;

    public static final int M01 = 11;
    public static final int M11 = 12;

    /** Speed at which the contact gives way to a unit impulse, 1/kg. */
    public static final int GIVE = 13;

    /** Speed at which the surfaces come together by turning, whatever the points do, m/s. */
    public static final int NEARING = 14;

    /** Width of the narrower body that moves, m: what tolerances are a share of. */
    public static final int WIDTH = 15;

    /** Friction: levers r × t, effective mass in kg, μ, impulse in N·s. */
    public static final int LEVER_TA = 16;

    public static final int LEVER_TB = 17;
    public static final int MASS_T = 18;
    public static final int FRICTION = 19;
    public static final int IMPULSE_T = 20;

    /** Normal impulse of the whole step, N·s. */
    public static final int TOTAL = 21;

    /** Force that the points carried of late, N. */
    static final int LOAD0 = 22;

    static final int LOAD1 = 23;

    /** What a unit impulse at point i gives point j, 1/kg. */
    public static final int K00 = 24;

    public static final int K01 = 25;
    public static final int K11 = 26;

    /** Rolling: effective inertia in kg·m², lever in m, angular impulse in N·m·s. */
    public static final int INERTIA_R = 27;

    public static final int ROLLING = 28;
    public static final int IMPULSE_R = 29;

    /** Elasticity, and the approach in m/s from which a contact bounces. */
    public static final int ELASTICITY = 30;

    public static final int BOUNCE_SPEED = 31;

    /** Share of an overlap taken back per second, 1/s. */
    public static final int RECOVERY = 32;

    /** Normal impulses of the kick before, N·s. */
    static final int BEFORE0 = 33;

    static final int BEFORE1 = 34;

    public static final int STRIDE = 35;

    /**
     * Compliance of every row, as a share of its effective inverse mass. It is too small to be
     * seen, but it makes the distribution of a load over redundant contacts unique; without it
     * their impulses drift.
     */
    public static final double COMPLIANCE = 1e-10;

    /** Contacts of one body that may carry something, at most. */
    static final int LOADED_PER_BODY = 4;

    /** The first substep of a contact that there was when the step began. */
    public static final int ALWAYS = -1;

    public double[] data = new double[16 * STRIDE];

    /** Offsets of A and B in {@link Motions}, the pair, its points, and the first substep. */
    public int[] bodyA = new int[16];

    public int[] bodyB = new int[16];
    public int[] pair = new int[16];
    public int[] points = new int[16];
    public int[] firstSubstep = new int[16];
    public int count;

    /** Bodies of the island, which move as its contacts tell them to. */
    private int bodies;

    /** Speed along the tangent at which friction lets B run on A: driven, or turning, m/s. */
    public double[] surface = new double[16];

    /** The part of it by which driven surfaces carry, m/s. */
    double[] running = new double[16];

    /** Whether a contact was measured again within the substep. */
    public boolean[] isNew = new boolean[16];

    /** Whether the surfaces of any of them run. */
    public boolean isAnyRunning;

    /** Whether any of them is crushed: deeper in each other than what overlap recovery leaves. */
    public boolean isAnyCrushed;

    /** The last substep in which a contact joins, {@link #ALWAYS} where none does. */
    public int lastJoining;

    /**
     * Contacts from here on are against what cannot give way. Every pass takes them last: what it
     * leaves unsolved is then between bodies, and none sinks into the floor.
     */
    public int groundStart;

    /** Impacts that were resolved between them. */
    public int impacts;

    /** What solving them took, and those of other islands before them. */
    public final IslandWork work = new IslandWork();

    /**
     * Adds a point to an impact: its arms follow from the levers along the normal and the tangent.
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

    /**
     * Whether so many contacts of so many bodies that move are too many for elimination. Most of
     * the contacts that one body may reach carry nothing: it has no more than three unknowns.
     */
    private static boolean areCrowd(int contacts, int bodies) {
        int loaded = Math.min(contacts, LOADED_PER_BODY * bodies);
        return loaded * SingleRows.ROWS_PER_CONTACT > SingleRows.MOST_ELIMINATED;
    }

    /** Whether an island has too many contacts for elimination, before they are packed. */
    public static boolean areCrowd(Islands islands, int island) {
        int contacts = islands.pairStart[island + 1] - islands.pairStart[island];
        int bodies = islands.bodyStart[island + 1] - islands.bodyStart[island];
        return areCrowd(contacts, bodies);
    }

    /** Whether the packed contacts are too many for elimination. */
    public boolean areCrowd() {
        return areCrowd(count, bodies);
    }

    /** Whether none is against what cannot give way: the bodies float. */
    public boolean areFloating() {
        return groundStart == count;
    }

    /**
     * The largest share of the contacts that carries something in a pile, where each stands on two.
     */
    public double shareLoaded() {
        return Math.min(1, 2.0 * bodies / count);
    }

    /** The largest change of speed by which a contact answers, m/s. */
    public double strongestAnswer() {
        double most = 0;
        for (int at = 0; at < count * STRIDE; at += STRIDE) {
            most = Math.max(most, (data[at + IMPULSE0] + data[at + IMPULSE1]) * data[at + K00]);
        }
        return most;
    }

    /** The width of the widest of the narrower bodies, m. */
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

    /** Whether a point carries something, or did in the kick before: what it does is left out. */
    public boolean carries(int row, int point) {
        int at = row * STRIDE + point;
        return data[at + IMPULSE0] > 0 || data[at + BEFORE0] > 0;
    }

    /** Takes a contact for one that has carried nothing yet. */
    public void unload(int row) {
        int at = row * STRIDE;
        data[at + IMPULSE0] = 0;
        data[at + IMPULSE1] = 0;
        data[at + IMPULSE_T] = 0;
        data[at + IMPULSE_R] = 0;
    }

    /** Scales what a contact carries. */
    public void scaleImpulses(int row, double share) {
        int at = row * STRIDE;
        data[at + IMPULSE0] *= share;
        data[at + IMPULSE1] *= share;
        data[at + IMPULSE_T] *= share;
        data[at + IMPULSE_R] *= share;
    }

    /** Takes a contact for one that joins in a substep. */
    public void joinsIn(int row, int substep) {
        unload(row);
        firstSubstep[row] = substep;
        lastJoining = Math.max(lastJoining, substep);
    }

    /** Empties the pack for an island of so many bodies. */
    void clear(int bodies) {
        this.bodies = bodies;
        count = 0;
        impacts = 0;
        isAnyRunning = false;
        isAnyCrushed = false;
        lastJoining = ALWAYS;
    }

    /** Takes all contacts for ones that have carried nothing yet. */
    public void unload() {
        for (int row = 0; row < count; row++) {
            unload(row);
        }
    }

    /** Adds the impulses of so many kicks like this one to those of the step. */
    public void addUpImpulses(int kicks) {
        for (int row = 0; row < count; row++) {
            addUpImpulses(row, kicks);
        }
    }

    /** The same of one contact. */
    public void addUpImpulses(int row, int kicks) {
        int at = row * STRIDE;
        data[at + TOTAL] += kicks * (data[at + IMPULSE0] + data[at + IMPULSE1]);
    }

    /** Makes room for one more contact and returns its index; its numbers are all 0. */
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
}
