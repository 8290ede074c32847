package rigibo.backend.contact.solve;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;

import java.util.Arrays;

/**
 * The order in which the contacts of an island are eliminated: breadth first from one end of the
 * pile to the other. Contacts that share a body are then near each other, and the envelope of the
 * factor stays narrow (E. Cuthill and J. McKee, Reducing the bandwidth of sparse symmetric
 * matrices, 1969).
 */
final class ContactOrder {

    private static final int NONE = -1;

    private final PackedContacts contacts;
    private final Motions motions;

    /** The contacts in order; and by contact its place in the order. */
    int[] order = new int[64];

    int[] place = new int[64];

    /** By place: the first place whose contact shares a body with the contact here. */
    int[] firstNeighbour = new int[64];

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
        int from = 0;
        while (from < contacts.count) {
            // The contact reached last is at an end of the pile; from there the levels are narrow.
            int any = firstWithoutPlace();
            int reached = walk(any, from);
            int end = order[reached - 1];
            forget(from, reached);
            from = walk(end, from);
        }
        findNeighbours();
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
        Arrays.fill(place, 0, contacts.count, NONE);
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

    private int firstWithoutPlace() {
        int row = 0;
        while (place[row] != NONE) {
            row++;
        }
        return row;
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
     * The ground, offset 0, connects no contacts, since it passes no impulse on.
     */
    private int takeNeighbours(int offset, int from) {
        int end = from;
        if (offset != 0) {
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
            int first = Math.min(i, firstOf(contacts.bodyA[order[i]], i));
            firstNeighbour[i] = Math.min(first, firstOf(contacts.bodyB[order[i]], i));
        }
    }

    private int firstOf(int offset, int otherwise) {
        int first = otherwise;
        if (offset != 0) {
            int body = body(offset);
            for (int i = start[body]; i < start[body + 1]; i++) {
                first = Math.min(first, place[ofBodies[i]]);
            }
        }
        return first;
    }
}
