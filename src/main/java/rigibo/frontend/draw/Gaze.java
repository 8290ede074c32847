package rigibo.frontend.draw;

/** The direction in which faces look, and the times at which they blink. */
final class Gaze {

    /** World, m. */
    double x;

    double y;

    /** Seconds since the window opened. */
    double seconds;
}
