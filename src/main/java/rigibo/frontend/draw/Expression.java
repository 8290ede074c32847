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

    /** A face blinks every so many seconds, one more often than another. */
    private static final double LEAST_PERIOD = 2.8;

    private static final double PERIODS = 2.9;

    /** How long the lids stay down, s; those that blink twice do so again after as long. */
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

    /** Whether the eyes are open, and pupils are to be seen. */
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
