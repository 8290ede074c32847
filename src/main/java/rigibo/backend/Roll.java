package rigibo.backend;

import java.util.Arrays;
import java.util.List;

/** Which bodies a pool held, in which slots, and in which order they were added. */
final class Roll {

    private RigidBody[] inOrder = {};
    private RigidBody[] bySlot = {};
    private int[] places = {};
    private int count;

    /**
     * Edition of the list at the last copy. It begins at 0, since a new list has edition 0 and is
     * as empty as this.
     */
    private int edition;

    /** Copies a list, unless it has not changed since the last copy. */
    void copy(BodyList bodies) {
        if (edition == bodies.edition()) {
            return;
        }
        edition = bodies.edition();
        int before = count;
        count = bodies.size();
        if (inOrder.length < count) {
            inOrder = new RigidBody[bodies.room()];
        } else if (before > count) {
            Arrays.fill(inOrder, count, before, null);
        }
        Arrays.fill(bySlot, null);
        if (bySlot.length < bodies.slots()) {
            bySlot = new RigidBody[bodies.slots()];
            places = new int[bodies.slots()];
        }
        for (int place = 0; place < count; place++) {
            RigidBody body = bodies.get(place);
            inOrder[place] = body;
            bySlot[body.slot()] = body;
            places[body.slot()] = place;
        }
    }

    boolean holds(RigidBody body) {
        int slot = body.everSlot();
        return slot < bySlot.length && bySlot[slot] == body;
    }

    RigidBody atSlot(int slot) {
        return bySlot[slot];
    }

    /** How many bodies were added before the one in a slot. */
    int place(int slot) {
        return places[slot];
    }

    List<RigidBody> all() {
        return List.of(Arrays.copyOf(inOrder, count));
    }
}
