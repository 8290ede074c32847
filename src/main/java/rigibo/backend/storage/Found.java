package rigibo.backend.storage;

import java.util.Arrays;

/** A list of whole numbers that can be emptied and refilled without allocation. */
public final class Found {

    public int[] numbers = new int[32];
    public int count;

    /** Empties the list. */
    public void clear() {
        count = 0;
    }

    /** Makes room for a number of entries; the present ones may be lost. */
    public void reserve(int capacity) {
        if (numbers.length < capacity) {
            numbers = new int[capacity];
        }
    }

    /** Sorts in ascending order, so that results do not depend on the order of finding. */
    public void sort() {
        Arrays.sort(numbers, 0, count);
    }

    /** Drops all numbers of a sorted list that equal the one before. */
    public void dropRepeated() {
        int kept = Math.min(1, count);
        for (int i = 1; i < count; i++) {
            if (numbers[i] != numbers[kept - 1]) {
                numbers[kept++] = numbers[i];
            }
        }
        count = kept;
    }

    /** Appends a number. */
    public void add(int number) {
        if (count == numbers.length) {
            numbers = Arrays.copyOf(numbers, Growth.after(count));
        }
        numbers[count++] = number;
    }
}
