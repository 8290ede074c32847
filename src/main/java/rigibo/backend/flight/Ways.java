package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.PointSpeeds;

import java.util.Arrays;

/**
 * How far the bodies of piles may be led off their predicted paths within a step. Where two would
 * be in each other at the end of the step, one may give way to the other along the normal, by a
 * share of its mass and of all that pushes from behind; what is fixed or driven pushes without
 * giving way. These ways are handed on from contact to contact until none grows. All speeds are
 * those of two bodies against each other, so nothing depends on the frame of reference.
 */
final class Ways {

    /** Factor by which a way must grow before it is handed on again. */
    static final double GROWN = 1.05;

    /** Bodies that have a way, in the order found. */
    final Found led = new Found();

    private final Bodies bodies;
    private final Pairs pairs;

    /** Length from which on a way is handed on, in widths of the contact. */
    private final double least;

    /** Overlap in widths that counts as none. */
    private final double kept;

    /**
     * By body, twice: how far it may be led off within the step, x and y, m; and the mass that
     * pushes, itself included, kg. The second way is opposed to the first.
     */
    private double[] wayX = new double[2 * 16];

    private double[] wayY = new double[2 * 16];
    private double[] mass = new double[2 * 16];

    /** By body: the last sweep in which one of its ways grew, 0 for none. */
    private int[] grownIn = new int[16];

    /** Contacts of piles; and by how much each would be overlapping at the end of the step, m. */
    private final Found contacts = new Found();

    private double[] closing = new double[32];

    /** Number of sweeps over the contacts in this step. */
    private int sweep;

    /** Number of contacts that have been swept. */
    private int known;

    /**
     * Ways that are handed on from a length of {@code least} widths on; an overlap of {@code kept}
     * widths is not removed.
     */
    Ways(DataStorage data, double least, double kept) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.least = least;
        this.kept = kept;
    }

    /** Starts a step without contacts or ways. */
    void begin() {
        int capacity = bodies.type.length;
        if (grownIn.length < capacity) {
            wayX = new double[2 * capacity];
            wayY = new double[2 * capacity];
            mass = new double[2 * capacity];
            grownIn = new int[capacity];
        }
        int high = bodies.slots.high;
        Arrays.fill(wayX, 0, 2 * high, 0);
        Arrays.fill(wayY, 0, 2 * high, 0);
        Arrays.fill(mass, 0, 2 * high, 0);
        Arrays.fill(grownIn, 0, high, 0);
        led.clear();
        contacts.clear();
        known = 0;
        sweep = 0;
    }

    /** Adds a measured contact of two bodies of piles, in a step of dt seconds. */
    void add(int pair, double dt) {
        contacts.add(pair);
        if (closing.length < contacts.numbers.length) {
            closing = Arrays.copyOf(closing, contacts.numbers.length);
        }
        closing[contacts.count - 1] = closing(pair, dt);
    }

    /** Number of contacts. */
    int contacts() {
        return contacts.count;
    }

    /**
     * Hands ways on until none grows. Sweeps go to and fro, since a way goes along a whole column
     * in one sweep if its contacts come in that order.
     */
    void handOn() {
        boolean isForward = true;
        boolean isGrowing = true;
        while (isGrowing) {
            sweep++;
            isGrowing = isForward ? sweepForward() : sweepBackward();
            isForward = !isForward;
            known = contacts.count;
        }
    }

    private boolean sweepForward() {
        boolean grows = false;
        for (int i = 0; i < contacts.count; i++) {
            grows |= handOn(i);
        }
        return grows;
    }

    private boolean sweepBackward() {
        boolean grows = false;
        for (int i = contacts.count - 1; i >= 0; i--) {
            grows |= handOn(i);
        }
        return grows;
    }

    /** Hands ways on through a contact if one has grown since it was last asked. */
    private boolean handOn(int contact) {
        int pair = contacts.numbers[contact];
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (contact < known && Math.max(grownIn[a], grownIn[b]) < sweep - 1) {
            return false;
        }
        boolean grows = push(pair, a, b, closing[contact]);
        return push(pair, b, a, closing[contact]) || grows;
    }

    /**
     * Leads a body off by what the other one of a contact may do to it; returns whether farther.
     */
    private boolean push(int pair, int by, int slot, double closing) {
        if (!mayMove(slot)) {
            return false;
        }
        double sign = slot == pairs.bodyB[pair] ? 1 : -1;
        double nx = sign * pairs.normalX[pair];
        double ny = sign * pairs.normalY[pair];
        boolean grows = lead(pair, slot, closing, ownMass(by), nx, ny);
        for (int way = 2 * by; way < 2 * by + 2; way++) {
            double along = along(way, nx, ny);
            if (along > 0) {
                grows |= lead(pair, slot, closing + along, mass[way], nx, ny);
            }
        }
        return grows;
    }

    /** Whether a body can be led off. */
    boolean mayMove(int slot) {
        return bodies.isDynamic(slot) && bodies.awake[slot];
    }

    private double ownMass(int slot) {
        return bodies.isDynamic(slot) ? 1 / bodies.inverseMass[slot] : Double.POSITIVE_INFINITY;
    }

    private boolean lead(int pair, int slot, double wanted, double pushing, double nx, double ny) {
        if (!(wanted > 0)) {
            return false;
        }
        double own = ownMass(slot);
        double share = pushing == Double.POSITIVE_INFINITY ? 1 : pushing / (pushing + own);
        double length = wanted * share;
        if (!(length > least * width(pair))) {
            return false;
        }
        int way = along(2 * slot, nx, ny) < 0 ? 2 * slot + 1 : 2 * slot;
        if (!(length > GROWN * lengthOf(way))) {
            return false;
        }
        wayX[way] = length * nx;
        wayY[way] = length * ny;
        mass[way] = pushing + own;
        if (grownIn[slot] == 0) {
            led.add(slot);
        }
        grownIn[slot] = sweep;
        return true;
    }

    private double along(int way, double nx, double ny) {
        return wayX[way] * nx + wayY[way] * ny;
    }

    private double lengthOf(int way) {
        return Math.sqrt(wayX[way] * wayX[way] + wayY[way] * wayY[way]);
    }

    /** Length of a body's longer way, m. */
    double reach(int slot) {
        return Math.max(lengthOf(2 * slot), lengthOf(2 * slot + 1));
    }

    /** How far a body may be led in a direction, m. */
    double ledTo(int slot, double nx, double ny) {
        return Math.max(along(2 * slot, nx, ny), along(2 * slot + 1, nx, ny));
    }

    /**
     * By how much a contact would be overlapping at the end of a step of dt seconds, m; it may be
     * negative. Overlap that is kept, as in a pile at rest, leads nobody off and does not count.
     */
    double closing(int pair, double dt) {
        double most = Double.NEGATIVE_INFINITY;
        double kept = this.kept * width(pair);
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            double separation = pairs.separation[point];
            double gap = Math.max(separation, Math.min(0, separation + kept));
            most = Math.max(most, -dt * parting(pair, point) - gap);
        }
        return most;
    }

    /** Width of a contact, m. */
    double width(int pair) {
        return PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
    }

    private double parting(int pair, int point) {
        if (bodies.turns()) {
            return PointSpeeds.parting(bodies, pairs, pair, point);
        }
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        return PairTolerances.along(
                bodies.velocityX[b] - bodies.velocityX[a],
                bodies.velocityY[b] - bodies.velocityY[a],
                pairs.normalX[pair],
                pairs.normalY[pair]);
    }
}
