package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.PointSpeeds;

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

    private final LedBodies entries;
    private final DueContacts contacts;

    /**
     * Ways that are handed on from a length of {@code least} widths on; an overlap of {@code kept}
     * widths is not removed.
     */
    Ways(DataStorage data, double least, double kept) {
        bodies = data.bodies;
        pairs = data.pairs;
        entries = new LedBodies(bodies);
        contacts = new DueContacts(entries);
        this.least = least;
        this.kept = kept;
    }

    /** Starts a step without contacts or ways. */
    void begin() {
        entries.clear();
        contacts.clear();
        led.clear();
    }

    /** Adds a measured contact of two bodies of piles, in a step of dt seconds. */
    void add(int pair, double dt) {
        int a = entries.entryOf(pairs.bodyA[pair]);
        int b = entries.entryOf(pairs.bodyB[pair]);
        int contact = contacts.add(a, b, pairs.normalX[pair], pairs.normalY[pair]);
        contacts.closing[contact] = closing(pair, dt);
        contacts.least[contact] = least * width(pair);
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
        while (contacts.firstFrom(0) < contacts.count) {
            sweepForward();
            sweepBackward();
        }
    }

    private void sweepForward() {
        int contact = contacts.firstFrom(0);
        while (contact < contacts.count) {
            ask(contact);
            contact = contacts.firstFrom(contact + 1);
        }
    }

    private void sweepBackward() {
        int contact = contacts.lastUpTo(contacts.count - 1);
        while (contact >= 0) {
            ask(contact);
            contact = contacts.lastUpTo(contact - 1);
        }
    }

    private void ask(int contact) {
        if (contacts.take(2 * contact)) {
            askSide(2 * contact);
        }
        if (contacts.take(2 * contact + 1)) {
            askSide(2 * contact + 1);
        }
    }

    /** Hands the ways of one body of a contact on to the other one. */
    private void askSide(int side) {
        int body = contacts.by[side ^ 1];
        if (entries.moves[body]) {
            double nx = contacts.normalX(side);
            double ny = contacts.normalY(side);
            boolean isSecond = entries.isSecondAlong(body, nx, ny);
            contacts.wasSecond[side] = isSecond;
            push(side / 2, contacts.by[side], body, isSecond ? LedBodies.STRIDE : 0, nx, ny);
        }
    }

    /**
     * Leads a body off by what the other one of a contact may do to it, along a normal, on the way
     * so many places after its first one.
     */
    private void push(int contact, int by, int body, int after, double nx, double ny) {
        double closing = contacts.closing[contact];
        double least = contacts.least[contact];
        double shortest = shortest(entries.firstWay(body) + after, least);
        boolean grows = false;
        // No way is longer than wanted, whatever the masses: most questions end here.
        if (closing > shortest && lead(body, after, shortest, closing, entries.mass[by], nx, ny)) {
            grows = true;
            shortest = shortest(entries.firstWay(body) + after, least);
        }
        int way = entries.firstWay(by);
        for (int i = 0; i < 2; i++, way += LedBodies.STRIDE) {
            double along = entries.along(way, nx, ny);
            double wanted = closing + along;
            double pushing = entries.ways[way + LedBodies.MASS];
            if (wanted > shortest
                    && along > 0
                    && lead(body, after, shortest, wanted, pushing, nx, ny)) {
                grows = true;
                shortest = shortest(entries.firstWay(body) + after, least);
            }
        }
        if (grows) {
            contacts.tell(body, after == 0);
        }
    }

    /** Length up to which a way is not lengthened, m. */
    private double shortest(int way, double least) {
        double known = GROWN * entries.ways[way + LedBodies.LENGTH];
        return known > least ? known : least;
    }

    /** Leads a body off on a way along a normal; returns whether farther than before. */
    private boolean lead(
            int body,
            int after,
            double shortest,
            double wanted,
            double pushing,
            double nx,
            double ny) {
        double own = entries.mass[body];
        double share = pushing == Double.POSITIVE_INFINITY ? 1 : pushing / (pushing + own);
        double length = wanted * share;
        if (!(length > shortest)) {
            return false;
        }
        if (!entries.isLed(body)) {
            entries.lead(body);
            led.add(entries.slot(body));
        }
        int way = entries.firstWay(body) + after;
        double x = length * nx;
        double y = length * ny;
        double[] ways = entries.ways;
        ways[way + LedBodies.X] = x;
        ways[way + LedBodies.Y] = y;
        ways[way + LedBodies.LENGTH] = Math.sqrt(x * x + y * y);
        ways[way + LedBodies.MASS] = pushing + own;
        return true;
    }

    /** Length of a body's longer way, m. */
    double reach(int slot) {
        int entry = entries.find(slot);
        return entry == LedBodies.NONE ? 0 : entries.reach(entry);
    }

    /** How far a body may be led in a direction, m. */
    double ledTo(int slot, double nx, double ny) {
        int entry = entries.find(slot);
        if (entry == LedBodies.NONE) {
            return 0;
        }
        int way = entries.firstWay(entry);
        return Math.max(entries.along(way, nx, ny), entries.along(way + LedBodies.STRIDE, nx, ny));
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
