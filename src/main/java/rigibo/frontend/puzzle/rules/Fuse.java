package rigibo.frontend.puzzle.rules;

import rigibo.frontend.puzzle.level.Steps;

/**
 * The fuse of a bomb that was lit.
 *
 * @param lit number of steps made before it was lit
 */
public record Fuse(int lit) {

    /** Burning time, steps. */
    private static final int LENGTH = Steps.of(1);

    /** Burnt share after a number of steps, 0 to 1. */
    public double burnt(int steps) {
        return Math.min(1, (steps - lit) / (double) LENGTH);
    }

    /** Whether it has burnt down after a number of steps. */
    public boolean isBurntDown(int steps) {
        return steps - lit >= LENGTH;
    }
}
