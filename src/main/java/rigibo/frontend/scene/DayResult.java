package rigibo.frontend.scene;

/**
 * A player's best game at a level of the day: fewest clicks first, then the shortest time.
 *
 * @param clicks that did something, 1 or more
 * @param steps of 1/60 s until it was won, 1 or more
 */
public record DayResult(int clicks, int steps) {

    public DayResult {
        if (clicks < 1) {
            throw new IllegalArgumentException("DayResult.clicks must be 1 or more, was " + clicks);
        }
        if (steps < 1) {
            throw new IllegalArgumentException("DayResult.steps must be 1 or more, was " + steps);
        }
    }

    /** Time until it was won, s. */
    public double seconds() {
        return steps * Scene.STEP;
    }

    /** The better of two games. */
    DayResult best(DayResult other) {
        boolean isBehind = other.clicks < clicks || other.clicks == clicks && other.steps < steps;
        return isBehind ? other : this;
    }
}
