package rigibo.frontend.sound;

/**
 * A decaying sine, which may glide: x(t) = a·e^(−t/τ)·sin φ(t), where t counts from its start and
 * the frequency is f(t) = to + (from − to)·e^(−t/τ).
 *
 * @param start s from the sample's start
 * @param from the frequency it starts at, Hz
 * @param to the frequency it tends to, Hz
 * @param amplitude a, beside those of the sample's other tones
 * @param decay τ in which it falls to 1/e, s
 */
record Tone(double start, double from, double to, double amplitude, double decay) {

    /** Where a tone is over, in decays: e^−7 is 61 dB below the start, out of hearing. */
    private static final double DECAYS = 7;

    Tone {
        if (!(start >= 0 && from > 0 && to > 0 && amplitude > 0 && decay > 0)) {
            throw new IllegalArgumentException(
                    String.format(
                            "Tone needs a start of 0 or more and all else positive, was"
                                    + " start %s s, %s to %s Hz, amplitude %s, decay %s s",
                            start, from, to, amplitude, decay));
        }
    }

    /** A tone at once and of one frequency. */
    static Tone steady(double frequency, double amplitude, double decay) {
        return new Tone(0, frequency, frequency, amplitude, decay);
    }

    /** When it is over, s. */
    double end() {
        return start + DECAYS * decay;
    }

    /** Adds it to a wave of {@link Sample#RATE}, as far as that reaches. */
    void addTo(double[] wave) {
        int first = (int) (start * Sample.RATE);
        int end = Math.min(wave.length, (int) (end() * Sample.RATE));
        double fading = Math.exp(-1 / (decay * Sample.RATE));
        double share = 1;
        for (int i = first; i < end; i++) {
            double t = (i - first) / (double) Sample.RATE;
            // The integral of f(t).
            double cycles = to * t + (from - to) * decay * (1 - share);
            wave[i] += amplitude * share * Math.sin(2 * Math.PI * cycles);
            share *= fading;
        }
    }
}
