package rigibo.frontend.draw;

/** Where faces look, and when: they blink now and then. */
final class Gaze {

    /** World, m. */
    double x;

    double y;

    /** Since the window opened. */
    double seconds;
}
