package rigibo.backend.flight;

import rigibo.backend.storage.Growth;

import java.util.Arrays;

/**
 * Contacts that ways are handed on through, with two sides each: from one, the ways of A are handed
 * on to B, from the other those of B to A. A side is due if its answer may be another one than when
 * it was last asked. Of the thousands in a crowd few are due at a time, which a bit each finds.
 */
final class DueContacts {

    private static final int SIDES_PER_WORD = 64;

    /** Number of contacts. */
    int count;

    /** By side: whose ways are handed on, an entry of {@link LedBodies}. */
    int[] by = new int[2 * 16];

    /** By contact: its normal from A to B. */
    private double[] normalX = new double[16];

    private double[] normalY = new double[16];

    /** By contact: by how much it would be overlapping at the end of the step, m. */
    double[] closing = new double[16];

    /** By contact: length from which on a way is handed on, m. */
    double[] least = new double[16];

    /** By side: whether the second way was to be lengthened when it was last asked. */
    boolean[] wasSecond = new boolean[2 * 16];

    private final LedBodies bodies;

    /** By side: the side that its body got before. */
    private int[] before = new int[2 * 16];

    /** By side, a bit each: whether it is due. */
    private long[] due = new long[1];

    DueContacts(LedBodies bodies) {
        this.bodies = bodies;
    }

    /** Removes all contacts. */
    void clear() {
        Arrays.fill(due, 0);
        count = 0;
    }

    /**
     * Adds a contact of two entries with a normal from A to B, whose sides are due, and returns its
     * number.
     */
    int add(int a, int b, double nx, double ny) {
        if (2 * count == by.length) {
            grow(Growth.after(count));
        }
        int contact = count++;
        addSide(2 * contact, a);
        addSide(2 * contact + 1, b);
        normalX[contact] = nx;
        normalY[contact] = ny;
        return contact;
    }

    private void addSide(int side, int body) {
        by[side] = body;
        before[side] = bodies.lastSide[body];
        bodies.lastSide[body] = side;
        set(side);
    }

    private void grow(int capacity) {
        normalX = Arrays.copyOf(normalX, capacity);
        normalY = Arrays.copyOf(normalY, capacity);
        closing = Arrays.copyOf(closing, capacity);
        least = Arrays.copyOf(least, capacity);
        by = Arrays.copyOf(by, 2 * capacity);
        wasSecond = Arrays.copyOf(wasSecond, 2 * capacity);
        before = Arrays.copyOf(before, 2 * capacity);
        due = Arrays.copyOf(due, 2 * capacity / SIDES_PER_WORD + 1);
    }

    private void set(int side) {
        due[side / SIDES_PER_WORD] |= 1L << side;
    }

    /** Takes a side if it is due; returns whether it was. */
    boolean take(int side) {
        long bit = 1L << side;
        boolean isDue = (due[side / SIDES_PER_WORD] & bit) != 0;
        due[side / SIDES_PER_WORD] &= ~bit;
        return isDue;
    }

    /**
     * Makes the sides due of which the answer may be another one since a way of a body has grown:
     * those from it, and where its first way has grown those that would lengthen another way of it.
     */
    void tell(int body, boolean isFirstWay) {
        for (int side = bodies.lastSide[body]; side != LedBodies.NONE; side = before[side]) {
            set(side);
            int other = side ^ 1;
            if (isFirstWay
                    && wasSecond[other]
                            != bodies.isSecondAlong(body, normalX(other), normalY(other))) {
                set(other);
            }
        }
    }

    /** A contact's normal away from a side's body, x. */
    double normalX(int side) {
        return sign(side) * normalX[side / 2];
    }

    /** A contact's normal away from a side's body, y. */
    double normalY(int side) {
        return sign(side) * normalY[side / 2];
    }

    /** 1 or -1; computed, since no processor could guess which. */
    private static double sign(int side) {
        return 1 - 2 * (side & 1);
    }

    /** The first contact from one on with a side that is due; {@link #count} if there is none. */
    int firstFrom(int contact) {
        int words = (2 * count + SIDES_PER_WORD - 1) / SIDES_PER_WORD;
        int word = 2 * contact / SIDES_PER_WORD;
        long mask = -1L << 2 * contact;
        while (word < words) {
            long bits = due[word] & mask;
            if (bits != 0) {
                return (word * SIDES_PER_WORD + Long.numberOfTrailingZeros(bits)) / 2;
            }
            mask = -1L;
            word++;
        }
        return count;
    }

    /** The last contact up to one with a side that is due; -1 if there is none. */
    int lastUpTo(int contact) {
        int side = 2 * contact + 1;
        int word = side < 0 ? -1 : side / SIDES_PER_WORD;
        long mask = -1L >>> -1 - side;
        while (word >= 0) {
            long bits = due[word] & mask;
            if (bits != 0) {
                int last = SIDES_PER_WORD - 1 - Long.numberOfLeadingZeros(bits);
                return (word * SIDES_PER_WORD + last) / 2;
            }
            mask = -1L;
            word--;
        }
        return -1;
    }
}
