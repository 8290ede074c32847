package rigibo.backend.collision;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * Poses of the bodies of active pairs at the start of the step before. Two bodies that have not
 * moved since, to the last bit, still touch at the same points. Other bodies are not compared, so
 * that sleeping ones cost nothing.
 */
final class Whereabouts {

    /** Pose, m and rad; NaN for a body that has not been compared yet. */
    private double[] x = {};

    private double[] y = {};
    private double[] angle = {};
    private boolean[] stayed = {};

    /** By body: the step in which it was last compared; and the number of this step. */
    private int[] lookedIn = {};

    private int step;

    /** Begins a step, in which every body is compared at most once. */
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

    /** Compares a body, unless it was already compared in this step. */
    void compare(Bodies bodies, int slot) {
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
    }

    /**
     * Whether a body compared in this step has the pose of its previous comparison; for a body of a
     * pair that was active in the step before, that was in that step.
     */
    boolean hasStayed(int slot) {
        return stayed[slot];
    }
}
