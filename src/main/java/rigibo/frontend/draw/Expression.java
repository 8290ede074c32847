package rigibo.frontend.draw;

import rigibo.frontend.scene.Canvas.Mood;

/** The expressions of a RigiBo's face, in the order of the shader that bakes the faces. */
enum Expression {
    CALM,
    BLINKING,
    WINCING,
    ASLEEP,
    WORRIED,
    CHEERING;

    private static final double GOLDEN = 0.6180339887498949;

    /** Shortest time between two blinks, s; other faces take up to {@link #PERIODS} longer. */
    private static final double LEAST_PERIOD = 2.8;

    private static final double PERIODS = 2.9;

    /**
     * Time for which the lids stay down, s; a face that blinks twice does so again after as long.
     */
    private static final double BLINK = 0.12;

    private static final double TWICE = 0.6;

    /**
     * The face of a body.
     *
     * @param number tells one face from another, so that they do not all blink at once
     * @param seconds since anything
     */
    static Expression of(Mood mood, int number, double seconds) {
        return switch (mood) {
            case HOVERED -> WINCING;
            case ASLEEP -> ASLEEP;
            case WORRIED -> isBlinking(number, seconds) ? BLINKING : WORRIED;
            case CHEERING -> CHEERING;
            case PLAIN, GHOST -> isBlinking(number, seconds) ? BLINKING : CALM;
        };
    }

    /** Whether the eyes are open, so that pupils can be seen. */
    boolean isOpen() {
        return this == CALM || this == WORRIED;
    }

    private static boolean isBlinking(int number, double seconds) {
        double own = (number + 1) * GOLDEN % 1;
        double period = LEAST_PERIOD + PERIODS * (own * number % 1);
        double since = (seconds + own * period) % period;
        boolean isSecond = own > TWICE && since >= 2 * BLINK && since < 3 * BLINK;
        return since < BLINK || isSecond;
    }
}
