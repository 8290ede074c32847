package rigibo.frontend.sound;

import rigibo.frontend.scene.Skin;

/**
 * A knock to be played.
 *
 * @param skin whose sample is played
 * @param gain 0 to 1
 * @param pitch speed relative to the sample of a body of 1 m
 */
record Knock(Skin skin, double gain, double pitch) {

    /**
     * As loud as it gets, N·s: a puzzle's stone that falls from a metre. A box that does so is at
     * two thirds of that, which leaves room for others.
     */
    private static final double LOUDEST = 6000;

    /**
     * How gain grows with impulse. Decibels grow with its logarithm, as hearing does: seven for ten
     * times the impulse, so that a drop of 60 g and a box of 300 kg are both heard.
     */
    private static final double LOUDNESS_EXPONENT = 0.35;

    /**
     * Exponent by which pitch falls with size. Among bodies of one shape, one twice as wide sounds
     * an octave lower: that is an exponent of 1. Half of it keeps the largest bodies within the
     * range of small loudspeakers.
     */
    private static final double PITCH_EXPONENT = 0.5;

    private static final double LOWEST = 0.4;
    private static final double HIGHEST = 3;

    /**
     * A knock of a body.
     *
     * @param size m
     * @param impulse N·s
     */
    static Knock of(Skin skin, double size, double impulse) {
        double gain = Math.min(1, Math.pow(impulse / LOUDEST, LOUDNESS_EXPONENT));
        double pitch = Math.pow(size, -PITCH_EXPONENT);
        return new Knock(skin, gain, Math.max(LOWEST, Math.min(HIGHEST, pitch)));
    }
}
