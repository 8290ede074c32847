package rigibo.frontend.sound;

/** How much of a frequency is in a sample. */
final class Spectrum {

    private Spectrum() {}

    /**
     * The magnitude of the Fourier sum at a frequency, Hz, by Goertzel's recurrence (An algorithm
     * for the evaluation of finite trigonometric series, 1958).
     */
    static double at(double frequency, Sample sample) {
        double turn = 2 * Math.cos(2 * Math.PI * frequency / Sample.RATE);
        double last = 0;
        double secondLast = 0;
        for (short value : sample.values()) {
            double next = value + turn * last - secondLast;
            secondLast = last;
            last = next;
        }
        return Math.sqrt(last * last + secondLast * secondLast - turn * last * secondLast);
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
