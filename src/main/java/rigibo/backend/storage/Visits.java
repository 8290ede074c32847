package rigibo.backend.storage;

import java.util.Arrays;

/**
 * Whose fixture reaches into that of a sensor, and what became of it in the last step: columns of a
 * sensor's shape and a visitor's, in the order in which they were found. They are there from the
 * first sensor on.
 */
public final class Visits {

    /** What became of a visit in the last step: nothing, */
    public static final int OUTSIDE = 0;

    /** the visitor came in and stayed, was in before, went out, or came in and went out. */
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

    /** Notes two shapes whose fixtures overlap, one of which is a sensor; known ones stay. */
    public void meet(Bodies bodies, int a, int b) {
        int first = Math.min(a, b);
        int second = Math.max(a, b);
        if (index.find(first, second) == PairIndex.ABSENT) {
            boolean isFirst = bodies.isSensor(first);
            add(isFirst ? first : second, isFirst ? second : first, OUTSIDE);
        }
    }

    /** Appends a visit; columns double in room as they grow. */
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

    /** Whether a visitor was inside as the last step ended. */
    public boolean isInside(int visit) {
        return state[visit] == ENTERED || state[visit] == INSIDE;
    }

    /** Moves a visit up to where others were dropped. */
    public void keep(int from, int to) {
        sensor[to] = sensor[from];
        visitor[to] = visitor[from];
        state[to] = state[from];
    }

    /** Forgets a visit in the index; the columns are closed up by {@link #keep}. */
    public void drop(int visit) {
        index.remove(
                Math.min(sensor[visit], visitor[visit]), Math.max(sensor[visit], visitor[visit]));
    }

    /** Forgets all visits of a shape that goes. */
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

    /** Forgets all. */
    public void clear() {
        for (int i = 0; i < count; i++) {
            drop(i);
        }
        count = 0;
    }
}
