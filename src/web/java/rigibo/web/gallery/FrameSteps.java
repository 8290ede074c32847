package rigibo.web.gallery;

/**
 * How many steps a picture makes, so that the world keeps the page's time: as a rule one at 60
 * pictures a second, none or one at more, and four at most. A page that was hidden goes on where it
 * was.
 */
final class FrameSteps {

    private static final int MOST = 4;
    private static final double MILLIS_PER_STEP = 1000.0 / 60;

    private double done = Double.NaN;

    /** Number of steps that are due at a time of the page in ms. */
    int due(double millis) {
        if (!(millis - done < (MOST + 1) * MILLIS_PER_STEP)) {
            done = millis - MILLIS_PER_STEP;
        }
        int due = (int) ((millis - done) / MILLIS_PER_STEP + 0.5);
        done += due * MILLIS_PER_STEP;
        return Math.min(due, MOST);
    }
}
