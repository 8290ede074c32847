package rigibo.backend.storage;

/**
 * Keeps the pairs in memory in the order in which a step meets them. Pairs come and go, and their
 * slots with them, until each of their columns is read at random: then the cache waits for memory
 * once per column and pair. When to sort them again follows from their order alone, and nothing
 * that is simulated depends on their numbers.
 */
public final class PairOrder {

    /** Pairs up to which all columns fit into the cache. */
    private static final int FEW = 1000;

    /** Share of steps back, from one active pair to the next, from which on they are sorted. */
    private static final double SCATTERED = 1.0 / 16;

    private final Bodies bodies;
    private final Pairs pairs;

    /** The old slot of each pair in its new one, and the other way round. */
    private int[] olds = new int[0];

    private int[] news = new int[0];

    /** Columns to sort into, one and two values a pair; each changes places with the one sorted. */
    private double[] numbers = new double[0];

    private double[] twinNumbers = new double[0];
    private int[] integers = new int[0];
    private int[] twinIntegers = new int[0];
    private boolean[] flags = new boolean[0];

    /** The order of the pairs of a storage. */
    public PairOrder(DataStorage data) {
        bodies = data.bodies;
        pairs = data.pairs;
    }

    /** Sorts the pairs if the active ones, which were just listed, lie too far about. */
    public void restore() {
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

    /** Active pairs first, as they are listed, then the others as they are. */
    private void listOrder() {
        int capacity = pairs.bodyA.length;
        if (numbers.length != capacity) {
            olds = new int[capacity];
            news = new int[capacity];
            numbers = new double[capacity];
            twinNumbers = new double[2 * capacity];
            integers = new int[capacity];
            twinIntegers = new int[2 * capacity];
            flags = new boolean[capacity];
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
        int count = pairs.slots.inUse();
        pairs.bodyA = sorted(pairs.bodyA, count);
        pairs.bodyB = sorted(pairs.bodyB, count);
        pairs.next = sortedTwins(linked(pairs.next), count);
        pairs.previous = sortedTwins(linked(pairs.previous), count);
        pairs.normalX = sorted(pairs.normalX, count);
        pairs.normalY = sorted(pairs.normalY, count);
        pairs.faceOf = sorted(pairs.faceOf, count);
        pairs.points = sorted(pairs.points, count);
        pairs.reach = sorted(pairs.reach, count);
        pairs.pointX = sortedTwins(pairs.pointX, count);
        pairs.pointY = sortedTwins(pairs.pointY, count);
        pairs.separation = sortedTwins(pairs.separation, count);
        pairs.feature = sortedTwins(pairs.feature, count);
        pairs.former = sortedTwins(pairs.former, count);
        pairs.normalForce = sortedTwins(pairs.normalForce, count);
        pairs.load = sortedTwins(pairs.load, count);
        pairs.friction = sorted(pairs.friction, count);
        pairs.elasticity = sorted(pairs.elasticity, count);
        pairs.frictionForce = sorted(pairs.frictionForce, count);
        pairs.rollingTorque = sorted(pairs.rollingTorque, count);
        pairs.impulse = sorted(pairs.impulse, count);
        pairs.impacts = sorted(pairs.impacts, count);
        pairs.crushed = sorted(pairs.crushed, count);
        pairs.resting = sorted(pairs.resting, count);
        pairs.touching = sorted(pairs.touching, count);
        pairs.touchedBefore = sorted(pairs.touchedBefore, count);
        pairs.activeStep = sorted(pairs.activeStep, count);
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            int first = bodies.type[slot] == null ? Pairs.NONE : bodies.firstPair[slot];
            bodies.firstPair[slot] = first == Pairs.NONE ? Pairs.NONE : news[first];
        }
        pairs.index.renumber(news);
        for (int i = 0; i < pairs.activeCount; i++) {
            pairs.active[i] = i;
        }
        pairs.slots.closeRanks();
    }

    /** Writes the new numbers of the pairs that a column of links names. */
    private int[] linked(int[] links) {
        for (int i = 0; i < pairs.slots.inUse(); i++) {
            int at = 2 * olds[i];
            links[at] = links[at] == Pairs.NONE ? Pairs.NONE : news[links[at]];
            links[at + 1] = links[at + 1] == Pairs.NONE ? Pairs.NONE : news[links[at + 1]];
        }
        return links;
    }

    private double[] sorted(double[] column, int count) {
        if (column == null) {
            return null;
        }
        double[] to = numbers;
        for (int i = 0; i < count; i++) {
            to[i] = column[olds[i]];
        }
        numbers = column;
        return to;
    }

    private double[] sortedTwins(double[] column, int count) {
        double[] to = twinNumbers;
        for (int i = 0; i < count; i++) {
            to[2 * i] = column[2 * olds[i]];
            to[2 * i + 1] = column[2 * olds[i] + 1];
        }
        twinNumbers = column;
        return to;
    }

    private int[] sorted(int[] column, int count) {
        int[] to = integers;
        for (int i = 0; i < count; i++) {
            to[i] = column[olds[i]];
        }
        integers = column;
        return to;
    }

    private int[] sortedTwins(int[] column, int count) {
        int[] to = twinIntegers;
        for (int i = 0; i < count; i++) {
            to[2 * i] = column[2 * olds[i]];
            to[2 * i + 1] = column[2 * olds[i] + 1];
        }
        twinIntegers = column;
        return to;
    }

    private boolean[] sorted(boolean[] column, int count) {
        boolean[] to = flags;
        for (int i = 0; i < count; i++) {
            to[i] = column[olds[i]];
        }
        flags = column;
        return to;
    }
}
