package rigibo.frontend.sound;

import java.util.SplittableRandom;

/** The rumble of rolling bodies: always playing, mostly at gain 0; louder and higher with speed. */
final class Rolling {

    /** The greatest gain. */
    static final double MOST = 0.15;

    /** At this speed it is as loud as it gets, m/s. */
    private static final double FAST = 6;

    /**
     * Share of the way to the wanted gain that is gone per turn: no step is heard, none is late.
     */
    private static final double SWIFTNESS = 0.2;

    private static final int LOWEST = 40;
    private static final int HIGHEST = 520;

    /** How far apart the sines are, Hz: whole, so that they come round within the loop's second. */
    private static final int SPACING = 3;

    private double told;
    private double gain;
    private double pitch = 1;

    /**
     * A second of noise out of sines, each a whole number of times, so that the end meets the
     * beginning; their amplitudes fall with 1/f, for rough ground is rougher the wider one looks.
     */
    static Sample sample() {
        SplittableRandom random = new SplittableRandom(2);
        double[] wave = new double[Sample.RATE];
        for (int frequency = LOWEST; frequency <= HIGHEST; frequency += SPACING) {
            addSine(frequency, 2 * Math.PI * random.nextDouble(), wave);
        }
        return Sample.loop(wave);
    }

    /**
     * By sin(φ + δ) = 2·cos δ·sin φ − sin(φ − δ): seven million sines would take a tenth of a
     * second.
     */
    private static void addSine(int frequency, double phase, double[] wave) {
        double step = 2 * Math.PI * frequency / Sample.RATE;
        double turn = 2 * Math.cos(step);
        double last = Math.sin(phase - step) / frequency;
        double secondLast = Math.sin(phase - 2 * step) / frequency;
        for (int i = 0; i < wave.length; i++) {
            double next = turn * last - secondLast;
            wave[i] += next;
            secondLast = last;
            last = next;
        }
    }

    /** Something rolls at a speed, m/s; the fastest of a turn is heard. */
    void tell(double speed) {
        told = Math.max(told, speed);
    }

    /** Ends a turn: bodies that were not reported again fall silent. */
    void turn() {
        double share = Math.min(1, told / FAST);
        gain += SWIFTNESS * (MOST * share - gain);
        pitch += SWIFTNESS * (0.7 + 0.8 * share - pitch);
        told = 0;
    }

    /** 0 to {@link #MOST}. */
    double gain() {
        return gain;
    }

    /** How many times as fast the sample is played. */
    double pitch() {
        return pitch;
    }
}
