package rigibo.frontend.sound;

/** How much of a frequency is in a sample. */
final class Spectrum {

    private Spectrum() {}

    /** The magnitude of the Fourier integral at a frequency, Hz, up to a factor. */
    static double at(double frequency, Sample sample) {
        double re = 0;
        double im = 0;
        short[] values = sample.values();
        for (int i = 0; i < values.length; i++) {
            double phase = 2 * Math.PI * frequency * i / Sample.RATE;
            re += values[i] * Math.cos(phase);
            im -= values[i] * Math.sin(phase);
        }
        return Math.hypot(re, im);
    }

    /** The strongest frequency in a range, Hz, to 1 Hz. */
    static double strongest(double from, double to, Sample sample) {
        double best = from;
        double most = 0;
        for (double frequency = from; frequency <= to; frequency++) {
            double magnitude = at(frequency, sample);
            if (magnitude > most) {
                most = magnitude;
                best = frequency;
            }
        }
        return best;
    }
}
