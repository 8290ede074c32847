package rigibo.backend.storage;

/**
 * Keeps the pairs in memory in the order in which a step visits them. As pairs come and go, their
 * slots are reused, until every column is read at random and the processor waits for memory once
 * per column and pair. The time to sort follows from the order of the pairs alone, and no result of
 * the simulation depends on their numbers.
 */
public final class PairOrder implements ColumnVisitor {

    /** Number of pairs up to which all columns fit into the cache. */
    private static final int FEW = 1000;

    /**
     * Sorts when the slot decreases from one active pair to the next in more than this share of
     * cases.
     */
    private static final double SCATTERED = 1.0 / 16;

    private final Bodies bodies;
    private final Pairs pairs;

    /** Old slot of each new one, and new slot of each old one. */
    private int[] olds = new int[0];

    private int[] news = new int[0];

    /**
     * Buffers to sort into, with one value a pair, from which a column is copied back. Numbers that
     * are whole are sorted into {@link #news}, which is free by then.
     */
    private double[] numbers = new double[0];

    private boolean[] flags = new boolean[0];

    /** Watches the order of the pairs of a storage. */
    public PairOrder(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Sorts the pairs if the active ones, which were just listed, are too scattered. */
    public void restore() {
        if (olds.length > 0) {
            // While the columns grow one after another, so do lists and buffers.
            lengthenOne(pairs.roomAhead());
        }
        if (pairs.activeCount > FEW && stepsBack() > SCATTERED * pairs.activeCount) {
            listOrder();
            renumber();
        }
    }

    private int stepsBack() {
        int count = 0;
        for (int i = 1; i < pairs.activeCount; i++) {
            count += pairs.active[i] < pairs.active[i - 1] ? 1 : 0;
        }
        return count;
    }

    /**
     * The active pairs first, in the order of their list, then the others in the order of their
     * slots.
     */
    private void listOrder() {
        while (lengthenOne(pairs.room())) {
            // The first time this makes them all, later only what was not made ahead.
        }
        int count = 0;
        for (int i = 0; i < pairs.activeCount; i++) {
            olds[count++] = pairs.active[i];
        }
        for (int pair = 0; pair < pairs.slots.high; pair++) {
            if (pairs.bodyA[pair] != Pairs.NONE && !pairs.isActive(pair)) {
                olds[count++] = pair;
            }
        }
        for (int pair = 0; pair < count; pair++) {
            news[olds[pair]] = pair;
        }
    }

    private void renumber() {
        linkAnew(pairs.next);
        linkAnew(pairs.previous);
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            int first = bodies.type[slot] == null ? Pairs.NONE : bodies.firstPair[slot];
            bodies.firstPair[slot] = first == Pairs.NONE ? Pairs.NONE : news[first];
        }
        pairs.index.renumber(news);
        pairs.visitColumns(this);
        for (int i = 0; i < pairs.activeCount; i++) {
            pairs.active[i] = i;
        }
        pairs.slots.closeRanks();
    }

    /** Replaces the numbers of pairs in a column of links. */
    private void linkAnew(int[] links) {
        for (int i = 0; i < pairs.slots.inUse(); i++) {
            int at = 2 * olds[i];
            links[at] = links[at] == Pairs.NONE ? Pairs.NONE : news[links[at]];
            links[at + 1] = links[at + 1] == Pairs.NONE ? Pairs.NONE : news[links[at + 1]];
        }
    }

    /** Lengthens one list or buffer that is too short; returns whether there was one. */
    private boolean lengthenOne(int capacity) {
        if (numbers.length < capacity) {
            numbers = new double[capacity];
        } else if (olds.length < capacity) {
            olds = new int[capacity];
        } else if (news.length < capacity) {
            news = new int[capacity];
        } else if (flags.length < capacity) {
            flags = new boolean[capacity];
        } else {
            return false;
        }
        return true;
    }

    @Override
    public <T> T[] column(String name, Role role, T[] column) {
        throw new AssertionError("pairs have no column of references, but " + name);
    }

    /** Sorts a column of some numbers for each pair, if there is one; returns it. */
    private double[] sorted(double[] column, int perSlot) {
        int count = pairs.slots.inUse();
        for (int first = 0; column != null && first < perSlot; first++) {
            for (int i = 0; i < count; i++) {
                numbers[i] = column[perSlot * olds[i] + first];
            }
            for (int i = 0; i < count; i++) {
                column[perSlot * i + first] = numbers[i];
            }
        }
        return column;
    }

    /** Sorts a column of some numbers for each pair, if there is one; returns it. */
    private int[] sorted(int[] column, int perSlot) {
        int count = pairs.slots.inUse();
        for (int first = 0; column != null && first < perSlot; first++) {
            for (int i = 0; i < count; i++) {
                news[i] = column[perSlot * olds[i] + first];
            }
            for (int i = 0; i < count; i++) {
                column[perSlot * i + first] = news[i];
            }
        }
        return column;
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column) {
        return sorted(column, 1);
    }

    @Override
    public double[] twins(String name, Role role, Need need, double[] column) {
        return sorted(column, 2);
    }

    @Override
    public int[] column(String name, Role role, Need need, int[] column) {
        return sorted(column, 1);
    }

    @Override
    public int[] twins(String name, Role role, Need need, int[] column) {
        return sorted(column, 2);
    }

    @Override
    public boolean[] column(String name, Role role, Need need, boolean[] column) {
        int count = pairs.slots.inUse();
        for (int i = 0; column != null && i < count; i++) {
            flags[i] = column[olds[i]];
        }
        if (column != null) {
            System.arraycopy(flags, 0, column, 0, count);
        }
        return column;
    }
}
