package rigibo.backend.storage;

import java.util.Arrays;

/**
 * Pairs of a sensor and a visitor, two shapes whose fixtures overlap, with the outcome of the last
 * step; in the order of finding. They exist from the first sensor on.
 */
public final class Visits {

    /** Outcome of the last step: the visitor was outside throughout. */
    public static final int OUTSIDE = 0;

    /**
     * The visitor came in and stayed; was inside throughout; went out; came in and went out again.
     */
    public static final int ENTERED = 1;

    public static final int INSIDE = 2;
    public static final int LEFT = 3;
    public static final int PASSED = 4;

    /** Slots of the shapes. */
    public int[] sensor = new int[16];

    public int[] visitor = new int[16];
    public int[] state = new int[16];
    public int count;

    private final PairIndex index = new PairIndex();

    /**
     * Notes two shapes whose fixtures overlap, one of which is a sensor, unless they are noted
     * already.
     */
    public void meet(Bodies bodies, int a, int b) {
        int first = Math.min(a, b);
        int second = Math.max(a, b);
        if (index.find(first, second) == PairIndex.ABSENT) {
            boolean isFirst = bodies.isSensor(first);
            add(isFirst ? first : second, isFirst ? second : first, OUTSIDE);
        }
    }

    /** Appends a visit. */
    public void add(int sensorShape, int visitorShape, int stateNow) {
        if (count == sensor.length) {
            sensor = Arrays.copyOf(sensor, 2 * count);
            visitor = Arrays.copyOf(visitor, 2 * count);
            state = Arrays.copyOf(state, 2 * count);
        }
        index.put(Math.min(sensorShape, visitorShape), Math.max(sensorShape, visitorShape), count);
        sensor[count] = sensorShape;
        visitor[count] = visitorShape;
        state[count] = stateNow;
        count++;
    }

    /** Whether a visitor was inside at the end of the last step. */
    public boolean isInside(int visit) {
        return state[visit] == ENTERED || state[visit] == INSIDE;
    }

    /** Moves a visit to an earlier place, where others were dropped. */
    public void keep(int from, int to) {
        sensor[to] = sensor[from];
        visitor[to] = visitor[from];
        state[to] = state[from];
    }

    /**
     * Removes a visit from the index; the caller closes the gap in the columns with {@link #keep}.
     */
    public void drop(int visit) {
        index.remove(
                Math.min(sensor[visit], visitor[visit]), Math.max(sensor[visit], visitor[visit]));
    }

    /** Removes all visits of a shape that is about to be removed. */
    public void forget(int slot) {
        int kept = 0;
        for (int i = 0; i < count; i++) {
            if (sensor[i] == slot || visitor[i] == slot) {
                drop(i);
            } else {
                keep(i, kept++);
            }
        }
        count = kept;
    }

    /** Removes all visits. */
    public void clear() {
        for (int i = 0; i < count; i++) {
            drop(i);
        }
        count = 0;
    }
}
