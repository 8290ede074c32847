package rigibo.backend.collision;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Where every body was when the step before began: two that have not moved since, to the last bit,
 * touch as they did.
 */
final class Whereabouts {

    private double[] x = {};
    private double[] y = {};
    private double[] angle = {};
    private boolean[] stayed = {};

    /** Finds out who has moved since the last time, and notes where all are now. */
    void compare(Bodies bodies) {
        if (x.length < bodies.type.length) {
            grow(bodies.type.length);
        }
        for (int slot = 0; slot < bodies.slots.high; slot++) {
            stayed[slot] =
                    x[slot] == bodies.x[slot]
                            && y[slot] == bodies.y[slot]
                            && angle[slot] == bodies.angle[slot];
            x[slot] = bodies.x[slot];
            y[slot] = bodies.y[slot];
            angle[slot] = bodies.angle[slot];
        }
    }

    private void grow(int capacity) {
        int old = x.length;
        x = Arrays.copyOf(x, capacity);
        y = Arrays.copyOf(y, capacity);
        angle = Arrays.copyOf(angle, capacity);
        stayed = new boolean[capacity];
        Arrays.fill(x, old, capacity, Double.NaN);
    }

    /** Whether a body is where it was. */
    boolean hasStayed(int slot) {
        return stayed[slot];
    }
}
