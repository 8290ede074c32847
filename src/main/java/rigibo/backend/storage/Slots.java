package rigibo.backend.storage;

import java.util.Arrays;

/**
 * Assigns slot numbers and takes them back. The slot returned last is assigned next, so that the
 * same calls always give the same numbers.
 */
public final class Slots {

    /** One more than the highest slot ever assigned. */
    public int high;

    /** Free slots, the next one to assign last; has room for all slots that were ever assigned. */
    public int[] free = new int[16];

    /** Number of entries in {@link #free}. */
    public int freeCount;

    /** Assigns a free slot. */
    public int take() {
        if (freeCount > 0) {
            return free[--freeCount];
        }
        if (high == free.length) {
            free = Arrays.copyOf(free, Growth.after(high));
        }
        return high++;
    }

    /** Takes a slot back. Once all slots are back, counting starts at 0 again. */
    public void giveBack(int slot) {
        free[freeCount++] = slot;
        if (freeCount == high) {
            closeRanks();
        }
    }

    /** Frees all slots above those in use, which have been moved to the lowest numbers. */
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
     * The slots in use, ascending.
     *
     * @throws IllegalArgumentException when a free slot was never assigned or is listed twice
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

    /** Number of slots in use. */
    public int inUse() {
        return high - freeCount;
    }
}
