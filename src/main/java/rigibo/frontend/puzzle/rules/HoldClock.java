package rigibo.frontend.puzzle.rules;

/**
 * Counts how long all balls together have stayed on the platform. Gaps shorter than the grace do
 * not reset it, but it can only finish while they touch the platform.
 */
final class HoldClock {

    private static final int NEVER = -1;

    private final int length;
    private final int grace;
    private int began = NEVER;
    private int lastTouch = NEVER;
    private boolean isTouching;

    HoldClock(int holdSteps, int graceSteps) {
        length = holdSteps;
        grace = graceSteps;
    }

    HoldClock copy() {
        HoldClock copy = new HoldClock(length, grace);
        copy.began = began;
        copy.lastTouch = lastTouch;
        copy.isTouching = isTouching;
        return copy;
    }

    /** Tells whether the two touched in the step that ended now. */
    void observe(int now, boolean touches) {
        isTouching = touches;
        if (began != NEVER && isLetGo(now - lastTouch - (touches ? 1 : 0))) {
            began = NEVER;
        }
        if (touches) {
            began = began == NEVER ? now : began;
            lastTouch = now;
        }
    }

    /** Whether a gap resets the hold. Consecutive steps never do, even with a grace of 0. */
    private boolean isLetGo(int stepsApart) {
        return stepsApart > 0 && stepsApart >= grace;
    }

    boolean isHeld(int now) {
        return isTouching && steps(now) >= length;
    }

    /** Whether the ball has ever been on the platform. */
    boolean hasTouched() {
        return lastTouch != NEVER;
    }

    /** Share of the hold that has passed, 0 to 1. */
    double fraction(int now) {
        return Math.min(1, steps(now) / (double) length);
    }

    private int steps(int now) {
        return began == NEVER ? 0 : now - began;
    }
}
