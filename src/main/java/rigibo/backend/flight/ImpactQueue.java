package rigibo.backend.flight;

import rigibo.backend.storage.Growth;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * The predicted impacts, earliest first, at most one per pair: a binary heap that knows the place
 * of each pair, so that a prediction can be replaced. Simultaneous impacts come in the order of
 * their bodies, which does not depend on other bodies.
 */
final class ImpactQueue {

    private static final int ABSENT = -1;

    private final Pairs pairs;

    /** By place in the heap: the pair, and the predicted time, s after the step's start. */
    private int[] heap = new int[16];

    private double[] time = new double[16];
    private int size;

    /** By pair: its place in the heap. */
    private int[] place = new int[0];

    ImpactQueue(Pairs pairs) {
        this.pairs = pairs;
    }

    /** Empties the queue; pairs are numbered below {@code pairCapacity}. */
    void clear(int pairCapacity) {
        for (int i = 0; i < size; i++) {
            place[heap[i]] = ABSENT;
        }
        size = 0;
        reserve(pairCapacity);
    }

    /** Makes room for pairs numbered below {@code pairCapacity}. */
    void reserve(int pairCapacity) {
        if (place.length < pairCapacity) {
            int old = place.length;
            place = Arrays.copyOf(place, pairCapacity);
            Arrays.fill(place, old, pairCapacity, ABSENT);
        }
    }

    boolean isEmpty() {
        return size == 0;
    }

    /** The pair whose impact comes first. */
    int first() {
        return heap[0];
    }

    /** Time of the first impact, s after the step's start. */
    double firstTime() {
        return time[0];
    }

    /** Predicted time of a pair's impact, s after the step's start; infinite if there is none. */
    double timeOf(int pair) {
        return place[pair] == ABSENT ? Double.POSITIVE_INFINITY : time[place[pair]];
    }

    /** Sets the predicted time of a pair's impact, in place of an earlier one. */
    void put(int pair, double when) {
        remove(pair);
        if (size == heap.length) {
            heap = Arrays.copyOf(heap, Growth.after(size));
            time = Arrays.copyOf(time, Growth.after(size));
        }
        time[size] = when;
        heap[size] = pair;
        place[pair] = size;
        up(size++);
    }

    /** Removes the predicted impact of a pair, if there is one. */
    void remove(int pair) {
        int at = place[pair];
        if (at == ABSENT) {
            return;
        }
        place[pair] = ABSENT;
        int last = heap[--size];
        if (last != pair) {
            heap[at] = last;
            time[at] = time[size];
            place[last] = at;
            up(at);
            down(place[last]);
        }
    }

    private void up(int from) {
        int at = from;
        while (at > 0 && isBefore(at, (at - 1) / 2)) {
            swap(at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
    }

    private void down(int from) {
        int at = from;
        while (2 * at + 1 < size) {
            int child = 2 * at + 1;
            if (child + 1 < size && isBefore(child + 1, child)) {
                child++;
            }
            if (!isBefore(child, at)) {
                return;
            }
            swap(at, child);
            at = child;
        }
    }

    /** Whether what is at one place comes before what is at another. */
    private boolean isBefore(int at, int than) {
        if (time[at] != time[than]) {
            return time[at] < time[than];
        }
        int pair = heap[at];
        int other = heap[than];
        int a = pairs.bodyA[pair];
        int otherA = pairs.bodyA[other];
        int b = pairs.bodyB[pair];
        int otherB = pairs.bodyB[other];
        return a != otherA ? a < otherA : b != otherB ? b < otherB : isOfFormerParts(pair, other);
    }

    /** Whether the first of two pairs of the same bodies has parts with lower indices. */
    private boolean isOfFormerParts(int pair, int other) {
        int a = pairs.shapeA(pair);
        int otherA = pairs.shapeA(other);
        return a != otherA ? a < otherA : pairs.shapeB(pair) < pairs.shapeB(other);
    }

    private void swap(int i, int j) {
        int pair = heap[i];
        double when = time[i];
        heap[i] = heap[j];
        time[i] = time[j];
        heap[j] = pair;
        time[j] = when;
        place[heap[i]] = i;
        place[heap[j]] = j;
    }
}
