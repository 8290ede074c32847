package rigibo.backend.collision;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Where the bodies of active pairs were when the step before began: two that have not moved since,
 * to the last bit, touch as they did. Nobody else is looked at, so that what sleeps costs nothing.
 */
final class Whereabouts {

    /** m and rad; NaN of whom nobody has looked for yet, who may have been anywhere. */
    private double[] x = {};

    private double[] y = {};
    private double[] angle = {};
    private boolean[] stayed = {};

    /** For each body the step in which it was last looked for, and the number of this. */
    private int[] lookedIn = {};

    private int step;

    /** Begins a step, in which every body is compared once. */
    void begin(Bodies bodies) {
        step++;
        int capacity = bodies.type.length;
        if (x.length < capacity) {
            int known = x.length;
            x = Arrays.copyOf(x, capacity);
            Arrays.fill(x, known, capacity, Double.NaN);
            y = Arrays.copyOf(y, capacity);
            angle = Arrays.copyOf(angle, capacity);
            stayed = Arrays.copyOf(stayed, capacity);
            lookedIn = Arrays.copyOf(lookedIn, capacity);
        }
    }

    /**
     * Whether a body is where it was when it was last looked for, which for a pair that was active
     * in the step before is then.
     */
    boolean hasStayed(Bodies bodies, int slot) {
        if (lookedIn[slot] != step) {
            lookedIn[slot] = step;
            stayed[slot] =
                    x[slot] == bodies.x[slot]
                            && y[slot] == bodies.y[slot]
                            && angle[slot] == bodies.angle[slot];
            x[slot] = bodies.x[slot];
            y[slot] = bodies.y[slot];
            angle[slot] = bodies.angle[slot];
        }
        return stayed[slot];
    }
}
