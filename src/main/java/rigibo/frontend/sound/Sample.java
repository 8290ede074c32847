package rigibo.frontend.sound;

import java.util.List;
import java.util.SplittableRandom;

/**
 * A sound to be played: mono, 16 bit. It starts at zero and, unless it is a loop, ends there, so
 * that neither end clicks; its peak is {@link #PEAK}.
 */
final class Sample {

    /** Values per second. */
    static final int RATE = 44_100;

    /** The greatest value, as a share of full scale: what resampling overshoots stays below 1. */
    static final double PEAK = 0.9;

    /** How long a sample may be, s. */
    private static final double LONGEST = 1.5;

    /** How long a note of the music may ring, s. */
    private static final double LONGEST_NOTE = 3;

    /** How long the ends take, s: too short to be heard as a change, too long for a click. */
    private static final double FADE_IN = 0.0005;

    private static final double FADE_OUT = 0.01;

    /** Hiss of a blow is over in this time, s. */
    private static final double HISS_DECAY = 0.004;

    private final short[] values;

    /**
     * The greatest value from each block of a hundredth of a second on, as a share of full scale.
     */
    private final double[] loudestFrom;

    private Sample(double[] wave) {
        values = quantized(wave);
        loudestFrom = loudestFrom(values);
    }

    /**
     * Tones together.
     *
     * @param hiss amplitude of the noise they begin with, beside theirs; 0 for none
     */
    static Sample of(List<Tone> tones, double hiss) {
        return of(tones, hiss, LONGEST);
    }

    /** Tones together that may ring on, as music does. */
    static Sample ringing(List<Tone> tones) {
        return of(tones, 0, LONGEST_NOTE);
    }

    private static Sample of(List<Tone> tones, double hiss, double longest) {
        double seconds = tones.stream().mapToDouble(Tone::end).max().orElseThrow();
        double[] wave = new double[(int) (Math.min(longest, seconds) * RATE)];
        tones.forEach(tone -> tone.addTo(wave));
        addHiss(wave, hiss);
        fade(wave);
        return new Sample(wave);
    }

    /** A wave that is played round and round: its end goes on with its beginning. */
    static Sample loop(double[] wave) {
        return new Sample(wave);
    }

    private static void addHiss(double[] wave, double amplitude) {
        SplittableRandom random = new SplittableRandom(1);
        double fading = Math.exp(-1 / (HISS_DECAY * RATE));
        double share = amplitude;
        for (int i = 0; i < wave.length && share > 0.001 * amplitude; i++) {
            wave[i] += share * (2 * random.nextDouble() - 1);
            share *= fading;
        }
    }

    private static void fade(double[] wave) {
        int in = (int) (FADE_IN * RATE);
        int out = (int) (FADE_OUT * RATE);
        for (int i = 0; i < wave.length; i++) {
            double share = Math.min(i / (double) in, (wave.length - 1 - i) / (double) out);
            wave[i] *= Math.min(1, share);
        }
    }

    private static short[] quantized(double[] wave) {
        double most = 0;
        for (double value : wave) {
            most = Math.max(most, Math.abs(value));
        }
        short[] quantized = new short[wave.length];
        for (int i = 0; i < wave.length; i++) {
            quantized[i] = (short) Math.round(wave[i] / most * PEAK * Short.MAX_VALUE);
        }
        return quantized;
    }

    private static double[] loudestFrom(short[] values) {
        int block = RATE / 100;
        double[] loudest = new double[values.length / block + 1];
        double most = 0;
        for (int i = values.length - 1; i >= 0; i--) {
            most = Math.max(most, Math.abs(values[i]) / (double) Short.MAX_VALUE);
            loudest[i / block] = most;
        }
        return loudest;
    }

    /** The samples to play; not to be written. */
    short[] values() {
        return values;
    }

    /** Its greatest value from a time on, s, as a share of full scale; 0 after its end. */
    double loudestFrom(double time) {
        int block = (int) (time * 100);
        return block < loudestFrom.length ? loudestFrom[block] : 0;
    }
}
