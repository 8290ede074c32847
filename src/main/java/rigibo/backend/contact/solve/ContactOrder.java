package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * The order in which the contacts of an island are eliminated: breadth first from one end of the
 * pile to the other. Contacts that share a body are then near each other, and the envelope of the
 * factor stays narrow (E. Cuthill and J. McKee, Reducing the bandwidth of sparse symmetric
 * matrices, 1969).
 *
 * <p>A body that many others lie on would couple all of their contacts. If that is most of the
 * work, it becomes a hub, whose velocity is an unknown of its own: it connects no contacts, and
 * those between hubs and immovable bodies come last.
 */
final class ContactOrder {

    private static final int NONE = -1;

    /** Number of contacts above which a body may become a hub: more than an equal one is among. */
    private static final int MANY = 8;

    /** Most hubs. */
    static final int MOST_HUBS = 4;

    /** Most work with hubs, as a share of that without, for which there are any. */
    private static final double WORTH_HUBS = 0.5;

    private final PackedContacts contacts;
    private final Motions motions;

    /** The contacts in order; and by contact its place in the order. */
    int[] order = new int[64];

    int[] place = new int[64];

    /**
     * By place: the first place whose contact shares a body with the contact here, not a hub; for a
     * contact of hubs alone, that of the first of its kind.
     */
    int[] firstNeighbour = new int[64];

    /** The hubs' offsets in the motions, and their number. */
    final int[] hubs = new int[MOST_HUBS];

    int hubCount;

    /** Number of contacts before those that have no movable body except hubs. */
    int beforeHubs;

    /** Most rows of a contact: one less than kinds where none has rolling resistance. */
    private int most;

    /**
     * The contacts of body {@code b}: {@code ofBodies[start[b]]} to {@code ofBodies[start[b + 1]]}.
     */
    int[] start = new int[65];

    int[] ofBodies = new int[128];

    ContactOrder(Motions motions, PackedContacts contacts) {
        this.motions = motions;
        this.contacts = contacts;
    }

    /** Orders the packed island's contacts. */
    void find() {
        reserve();
        listContacts();
        most = isAnyRolling() ? FlatRows.KINDS : FlatRows.KINDS - 1;
        hubCount = 0;
        orderAll();
        double withoutHubs = work();
        chooseHubs();
        if (hubCount > 0) {
            orderAll();
            if (work() > WORTH_HUBS * withoutHubs) {
                hubCount = 0;
                orderAll();
            }
        }
    }

    private void chooseHubs() {
        for (int body = 1; body < motions.count && hubCount < MOST_HUBS; body++) {
            int offset = body * Motions.STRIDE;
            if (start[body + 1] - start[body] > MANY && connects(offset)) {
                hubs[hubCount++] = offset;
            }
        }
    }

    boolean isHub(int offset) {
        for (int i = 0; i < hubCount; i++) {
            if (hubs[i] == offset) {
                return true;
            }
        }
        return false;
    }

    /**
     * Estimated multiplications of factoring the rows of all contacts, from their envelope, with
     * the unknowns of hubs.
     */
    double work() {
        double work = 0;
        int ofHubs = FlatRows.AXES * hubCount;
        for (int at = 0; at < contacts.count; at++) {
            double width = most * (at - firstNeighbour[at] + 1);
            double ofHub = at < beforeHubs ? width * ofHubs : ofHubs * (width + ofHubs / 2.0);
            work += most * (width * width / 2 + ofHub);
        }
        return work + ofHubs * ofHubs * ofHubs / 6.0;
    }

    /** How many times as much work an island of as many contacts is if some have four rows. */
    double timesByRolling() {
        double times = most / (FlatRows.KINDS - 1.0);
        return times * times * times;
    }

    private boolean isAnyRolling() {
        boolean isAny = false;
        for (int row = 0; row < contacts.count; row++) {
            isAny |= contacts.data[row * PackedContacts.STRIDE + PackedContacts.ROLLING] > 0;
        }
        return isAny;
    }

    private void orderAll() {
        Arrays.fill(place, 0, contacts.count, NONE);
        int from = 0;
        for (int row = 0; row < contacts.count; row++) {
            if (place[row] == NONE && isConnected(row)) {
                // The contact reached last is at an end of the pile; from there levels are narrow.
                int reached = walk(row, from);
                int end = order[reached - 1];
                forget(from, reached);
                from = walk(end, from);
            }
        }
        beforeHubs = from;
        for (int row = 0; row < contacts.count; row++) {
            if (place[row] == NONE) {
                place[row] = from;
                order[from++] = row;
            }
        }
        findNeighbours();
    }

    private boolean isConnected(int row) {
        return connects(contacts.bodyA[row]) || connects(contacts.bodyB[row]);
    }

    /**
     * Whether a body connects its contacts. One that is not moved by impulses, as the ground,
     * offset 0, does not, since it passes none on.
     */
    boolean connects(int offset) {
        double[] m = motions.data;
        return (m[offset + Motions.INVERSE_MASS] > 0 || m[offset + Motions.INVERSE_INERTIA] > 0)
                && !isHub(offset);
    }

    private void reserve() {
        if (order.length < contacts.count) {
            order = new int[contacts.pair.length];
            place = new int[contacts.pair.length];
            firstNeighbour = new int[contacts.pair.length];
            ofBodies = new int[2 * contacts.pair.length];
        }
        if (start.length <= motions.count) {
            start = new int[motions.slots.length + 1];
        }
    }

    /**
     * Counts each body's contacts, turns counts into starts, and fills the lists from their ends.
     */
    private void listContacts() {
        Arrays.fill(start, 0, motions.count + 1, 0);
        for (int row = 0; row < contacts.count; row++) {
            start[body(contacts.bodyA[row])]++;
            start[body(contacts.bodyB[row])]++;
        }
        for (int body = 1; body <= motions.count; body++) {
            start[body] += start[body - 1];
        }
        for (int row = contacts.count - 1; row >= 0; row--) {
            ofBodies[--start[body(contacts.bodyA[row])]] = row;
            ofBodies[--start[body(contacts.bodyB[row])]] = row;
        }
    }

    private static int body(int offset) {
        return offset / Motions.STRIDE;
    }

    /** Gives places from {@code from} on to all contacts connected with a contact. */
    private int walk(int first, int from) {
        int end = from;
        place[first] = end;
        order[end++] = first;
        for (int at = from; at < end; at++) {
            end = takeNeighbours(contacts.bodyA[order[at]], end);
            end = takeNeighbours(contacts.bodyB[order[at]], end);
        }
        return end;
    }

    /**
     * Gives places from {@code from} on to the contacts of a body that have none; returns the end.
     */
    private int takeNeighbours(int offset, int from) {
        int end = from;
        if (connects(offset)) {
            int body = body(offset);
            for (int i = start[body]; i < start[body + 1]; i++) {
                if (place[ofBodies[i]] == NONE) {
                    place[ofBodies[i]] = end;
                    order[end++] = ofBodies[i];
                }
            }
        }
        return end;
    }

    private void forget(int from, int to) {
        for (int i = from; i < to; i++) {
            place[order[i]] = NONE;
        }
    }

    private void findNeighbours() {
        for (int i = 0; i < contacts.count; i++) {
            int last = i < beforeHubs || hubCount == 0 ? i : beforeHubs;
            int first = Math.min(last, firstOf(contacts.bodyA[order[i]], i));
            firstNeighbour[i] = Math.min(first, firstOf(contacts.bodyB[order[i]], i));
        }
    }

    private int firstOf(int offset, int otherwise) {
        int first = otherwise;
        if (connects(offset)) {
            int body = body(offset);
            for (int i = start[body]; i < start[body + 1]; i++) {
                first = Math.min(first, place[ofBodies[i]]);
            }
        }
        return first;
    }
}
