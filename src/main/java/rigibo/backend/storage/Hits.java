package rigibo.backend.storage;

import java.util.Arrays;

/**
 * The impacts of the last step, in the order in which they were resolved. No step reads them; they
 * exist where a stage resolves impacts.
 */
public final class Hits {

    /** Most hits kept of a step, some 5 MB; further ones are not reported. */
    private static final int MOST = 1 << 16;

    private static final int FORETOLD = 1;
    private static final int EXPECTED = 2;

    /** Slots of the two bodies, the struck part of each, and the slot of their pair. */
    public int[] bodyA = new int[16];

    public int[] bodyB = new int[16];
    public int[] partA = new int[16];
    public int[] partB = new int[16];
    private int[] pair = new int[16];

    /** World position, m, and the unit normal from A to B. */
    public double[] x = new double[16];

    public double[] y = new double[16];
    public double[] normalX = new double[16];
    public double[] normalY = new double[16];

    /** Closing speed along the normal, m/s, and time, s after the step's start. */
    public double[] speed = new double[16];

    public double[] time = new double[16];
    public int count;

    /** By pair: whether its hit was noted before a solver resolves it. */
    private boolean[] isForetold = new boolean[16];

    /** Pairs whose hits are expected of a solver, and by pair, whether it has not told one yet. */
    private final Found expected = new Found();

    private boolean[] isExpected = new boolean[16];

    /** Of each of them place, closing speed and time: x, y, speed, time. */
    private double[] expectedHit = new double[4 * 16];

    /** Slots of bodies that were removed since the step; then, by slot, whether a body was. */
    private final Found removed = new Found();

    private boolean[] isRemoved = new boolean[16];

    /** Begins a step, with room for a number of pairs. */
    public void clear(int pairRoom) {
        for (int i = 0; i < count; i++) {
            if (pair[i] < isForetold.length) {
                isForetold[pair[i]] = false;
            }
        }
        reserve(pairRoom);
        count = 0;
        expected.clear();
        for (int i = 0; i < removed.count; i++) {
            isRemoved[removed.numbers[i]] = false;
        }
        removed.clear();
    }

    /**
     * Notes a hit of a pair if its two shapes approach each other; sliding or parting is no hit.
     */
    public void add(
            Bodies bodies, Pairs pairs, int of, double atX, double atY, double closing, double at) {
        if (of < isExpected.length) {
            isExpected[of] = false;
        }
        if (!(closing > 0) || count == MOST) {
            return;
        }
        if (count == bodyA.length) {
            grow();
        }
        pair[count] = of;
        bodyA[count] = pairs.bodyA[of];
        bodyB[count] = pairs.bodyB[of];
        partA[count] = bodies.partOf(pairs.shapeA(of));
        partB[count] = bodies.partOf(pairs.shapeB(of));
        x[count] = atX;
        y[count] = atY;
        normalX[count] = pairs.normalX[of];
        normalY[count] = pairs.normalY[of];
        speed[count] = closing;
        time[count] = at;
        count++;
    }

    /** Begins a list of a worker's own: what is noted by pair is shared, since pairs are not. */
    void beginShared(Hits shared) {
        isForetold = shared.isForetold;
        isExpected = shared.isExpected;
        count = 0;
    }

    /** Adds hits of a worker's own list. */
    public void append(Hits other, int from, int to) {
        for (int i = from; i < to && count < MOST; i++) {
            if (count == bodyA.length) {
                grow();
            }
            pair[count] = other.pair[i];
            bodyA[count] = other.bodyA[i];
            bodyB[count] = other.bodyB[i];
            partA[count] = other.partA[i];
            partB[count] = other.partB[i];
            x[count] = other.x[i];
            y[count] = other.y[i];
            normalX[count] = other.normalX[i];
            normalY[count] = other.normalY[i];
            speed[count] = other.speed[i];
            time[count] = other.time[i];
            count++;
        }
    }

    /**
     * Expects a hit of a pair that is about to meet in a pile. A later call for a pair counts in
     * place of an earlier one.
     */
    public void expect(int of, double atX, double atY, double closing, double at) {
        if (isExpected.length <= of) {
            isExpected = Arrays.copyOf(isExpected, Math.max(of + 1, 2 * isExpected.length));
        }
        int entry = 4 * expected.count;
        if (expectedHit.length <= entry) {
            expectedHit = Arrays.copyOf(expectedHit, 2 * expectedHit.length);
        }
        isExpected[of] = true;
        expected.add(of);
        expectedHit[entry] = atX;
        expectedHit[entry + 1] = atY;
        expectedHit[entry + 2] = closing;
        expectedHit[entry + 3] = at;
    }

    /**
     * Notes the hits that were expected, of pairs that pressed each other in the step and whose
     * solver has told none: it tells only what may rebound.
     */
    public void tellExpected(Bodies bodies, Pairs pairs) {
        for (int i = expected.count - 1; i >= 0; i--) {
            int of = expected.numbers[i];
            if (isExpected[of] && pairs.impulse[of] > 0) {
                double[] hit = expectedHit;
                add(bodies, pairs, of, hit[4 * i], hit[4 * i + 1], hit[4 * i + 2], hit[4 * i + 3]);
            }
            isExpected[of] = false;
        }
        expected.clear();
    }

    /** Marks the hit of a pair that was just added as one that a solver will resolve later. */
    public void foretell(int of) {
        reserve(of + 1);
        isForetold[of] = count > 0 && pair[count - 1] == of;
    }

    /**
     * Whether the hit of a pair that a solver now resolves is already noted; clears the mark, so
     * that the pair's next hit is noted again.
     */
    public boolean wasForetold(int of) {
        boolean was = isForetold(of);
        if (was) {
            isForetold[of] = false;
        }
        return was;
    }

    private boolean isForetold(int of) {
        return of < isForetold.length && isForetold[of];
    }

    /** What is expected of a pair's solver, as bits for {@link #markAgain}. */
    public int marks(int of) {
        boolean expects = of < isExpected.length && isExpected[of];
        return (isForetold(of) ? FORETOLD : 0) | (expects ? EXPECTED : 0);
    }

    /** Marks a pair as it was before a step that is made again. */
    public void markAgain(int of, int marks) {
        if ((marks & FORETOLD) != 0) {
            isForetold[of] = true;
        }
        if ((marks & EXPECTED) != 0) {
            isExpected[of] = true;
        }
    }

    private void reserve(int pairRoom) {
        if (isForetold.length < pairRoom) {
            isForetold = Arrays.copyOf(isForetold, Math.max(pairRoom, 2 * isForetold.length));
        }
    }

    /** Notes that a body is removed: another body may get its slot before the next step. */
    public void remove(int slot) {
        if (slot >= isRemoved.length) {
            isRemoved = Arrays.copyOf(isRemoved, Math.max(slot + 1, 2 * isRemoved.length));
        }
        if (count > 0 && !isRemoved[slot]) {
            isRemoved[slot] = true;
            removed.add(slot);
        }
    }

    /** Whether both bodies of a hit still exist. */
    public boolean areThere(int hit) {
        return removed.count == 0 || !wasRemoved(bodyA[hit]) && !wasRemoved(bodyB[hit]);
    }

    private boolean wasRemoved(int slot) {
        return slot < isRemoved.length && isRemoved[slot];
    }

    private void grow() {
        int capacity = 2 * count;
        pair = Arrays.copyOf(pair, capacity);
        bodyA = Arrays.copyOf(bodyA, capacity);
        bodyB = Arrays.copyOf(bodyB, capacity);
        partA = Arrays.copyOf(partA, capacity);
        partB = Arrays.copyOf(partB, capacity);
        x = Arrays.copyOf(x, capacity);
        y = Arrays.copyOf(y, capacity);
        normalX = Arrays.copyOf(normalX, capacity);
        normalY = Arrays.copyOf(normalY, capacity);
        speed = Arrays.copyOf(speed, capacity);
        time = Arrays.copyOf(time, capacity);
    }
}
