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

    /** Takes a slot back. Once all are back none waits: it is as if none had been handed out. */
    public void giveBack(int slot) {
        free[freeCount++] = slot;
        if (freeCount == high) {
            closeRanks();
        }
    }

    /** What is in use has been moved to the lowest slots: none is free among them. */
    void closeRanks() {
        high = inUse();
        freeCount = 0;
    }

    /** Makes room for as many free slots as there can be. */
    public void reserveFree() {
        if (free.length < high) {
            free = Arrays.copyOf(free, high);
        }
    }

    /**
     * The slots that are handed out, ascending.
     *
     * @throws IllegalArgumentException when a free slot was never handed out or is listed twice
     */
    public int[] occupied() {
        boolean[] isFree = new boolean[high];
        for (int i = 0; i < freeCount; i++) {
            int slot = free[i];
            if (slot < 0 || slot >= high || isFree[slot]) {
                throw new IllegalArgumentException(
                        "a free slot must be 0 to " + (high - 1) + ", each once, was " + slot);
            }
            isFree[slot] = true;
        }
        int[] occupied = new int[inUse()];
        int count = 0;
        for (int slot = 0; slot < high; slot++) {
            if (!isFree[slot]) {
                occupied[count++] = slot;
            }
        }
        return occupied;
    }

    /** How many slots are handed out. */
    public int inUse() {
        return high - freeCount;
    }
}
