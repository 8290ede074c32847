package rigibo.backend.storage;

import java.util.Arrays;

/**
 * The bodies that a step visits, in slot order: awake dynamic ones and moving kinematic ones. It is
 * rebuilt only when a body was added, removed, put to sleep or woken, so that a sleeping body costs
 * nothing.
 */
public final class Roster {

    /** Slots of awake dynamic bodies and of moving kinematic bodies, ascending. */
    public int[] awake = new int[16];

    public int awakeCount;

    /** Set by every stage that adds, removes, wakes or stops a body. */
    public boolean isStale = true;

    /** Rebuilds the list if it is stale. */
    public void refresh(Bodies bodies) {
        if (!isStale) {
            return;
        }
        if (awake.length < bodies.type.length) {
            awake = new int[bodies.type.length];
        }
        awakeCount = 0;
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            if (bodies.isMoved(slot)) {
                awake[awakeCount++] = slot;
            }
        }
        isStale = false;
    }

    /** Appends a body that woke within the step; the next refresh restores the order. */
    public void join(int slot) {
        if (awakeCount == awake.length) {
            awake = Arrays.copyOf(awake, 2 * awakeCount);
        }
        awake[awakeCount++] = slot;
        isStale = true;
    }
}
