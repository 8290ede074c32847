package rigibo.frontend.puzzle.rules;

import rigibo.frontend.puzzle.level.Steps;

/**
 * The melting of a fire door that a ball has touched.
 *
 * @param touched number of steps made before the contact
 */
public record Melt(int touched) {

    /** Duration, steps: long enough to be seen, and too short for another click. */
    private static final int LENGTH = Steps.of(0.5);

    /** Melted share after a number of steps, 0 to 1. */
    public double share(int steps) {
        return Math.min(1, (steps - touched) / (double) LENGTH);
    }

    /** Whether it has melted after a number of steps. */
    public boolean isOver(int steps) {
        return steps - touched >= LENGTH;
    }
}
