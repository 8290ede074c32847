package rigibo.frontend.puzzle.rules;

import rigibo.frontend.puzzle.level.Steps;

/**
 * The end of a fire door that a ball has touched.
 *
 * @param touched number of steps done when it was
 */
public record Melt(int touched) {

    /** How long it takes, steps: long enough to be seen, and too short for another click. */
    private static final int LENGTH = Steps.of(0.5);

    /** How much of it has melted after so many steps, 0 to 1. */
    public double share(int steps) {
        return Math.min(1, (steps - touched) / (double) LENGTH);
    }

    /** Whether nothing is left of it after so many steps. */
    public boolean isOver(int steps) {
        return steps - touched >= LENGTH;
    }
}
