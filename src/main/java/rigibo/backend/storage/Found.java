package rigibo.backend.storage;

import java.util.Arrays;

/** A list of numbers that is filled and emptied again and again without allocating. */
public final class Found {

    public int[] numbers = new int[32];
    public int count;

    /** Empties the list. */
    public void clear() {
        count = 0;
    }

    /** Makes room for so many numbers; contents are to be written anew. */
    public void reserve(int capacity) {
        if (numbers.length < capacity) {
            numbers = new int[capacity];
        }
    }

    /** Sorts ascending, so that what follows does not depend on the order of finding. */
    public void sort() {
        Arrays.sort(numbers, 0, count);
    }

    /** Appends a number. */
    public void add(int number) {
        if (count == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * count);
        }
        numbers[count++] = number;
    }
}
