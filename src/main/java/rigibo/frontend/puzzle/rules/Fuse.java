package rigibo.frontend.puzzle.rules;

import rigibo.frontend.puzzle.level.Steps;

/**
 * The fuse of a bomb that was lit.
 *
 * @param lit number of steps done when it was
 */
public record Fuse(int lit) {

    /** How long it burns, steps. */
    private static final int LENGTH = Steps.of(1);

    /** How much of it has burnt after so many steps, 0 to 1. */
    public double burnt(int steps) {
        return Math.min(1, (steps - lit) / (double) LENGTH);
    }

    /** Whether it has burnt down after so many steps. */
    public boolean isBurntDown(int steps) {
        return steps - lit >= LENGTH;
    }
}
