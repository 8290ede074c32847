package rigibo.backend.storage;

import java.util.Arrays;

/**
 * The bodies that a step has to look at, in slot order: awake dynamic ones and driven ones. Rebuilt
 * only when bodies came, went, slept or woke, so that a sleeping body costs nothing.
 */
public final class Roster {

    /** Slots of the awake dynamic bodies and of kinematic bodies that move, ascending. */
    public int[] awake = new int[16];

    public int awakeCount;

    /** Set by whoever adds, removes, wakes or puts to sleep a body. */
    public boolean isStale = true;

    /** Lists the bodies anew if anything changed. */
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

    /** Adds a body that woke within the step, at the end of the list until the next refresh. */
    public void join(int slot) {
        if (awakeCount == awake.length) {
            awake = Arrays.copyOf(awake, 2 * awakeCount);
        }
        awake[awakeCount++] = slot;
        isStale = true;
    }
}
