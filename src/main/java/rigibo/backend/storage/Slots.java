package rigibo.backend.storage;

import java.util.Arrays;

/**
 * Hands out slot numbers and takes them back. The last one returned is the next handed out, so the
 * same calls give the same numbers.
 */
public final class Slots {

    /** One more than the highest slot ever handed out. */
    public int high;

    /** Returned slots, the next to hand out last; has room for all that were ever handed out. */
    public int[] free = new int[16];

    /** How many slots wait in {@link #free}. */
    public int freeCount;

    /** A slot that nobody has. */
    public int take() {
        if (freeCount > 0) {
            return free[--freeCount];
        }
        if (high == free.length) {
            free = Arrays.copyOf(free, 2 * high);
        }
        return high++;
    }

    /** Takes a slot back. */
    public void giveBack(int slot) {
        free[freeCount++] = slot;
    }

    /** How many slots are handed out. */
    public int inUse() {
        return high - freeCount;
    }
}
