package rigibo.frontend.puzzle.level;

/** Converts between the seconds of level files and the steps of the rules; no other class does. */
public final class Steps {

    /** Steps of a second. */
    public static final int PER_SECOND = 60;

    /** Length of a step, s. */
    public static final double SECONDS = 1.0 / PER_SECOND;

    private Steps() {}

    /** The number of steps nearest to a time. */
    public static int of(double seconds) {
        return Math.toIntExact(Math.round(seconds * PER_SECOND));
    }

    /** The time after a number of steps, s. */
    public static double seconds(int steps) {
        return steps / (double) PER_SECOND;
    }
}
