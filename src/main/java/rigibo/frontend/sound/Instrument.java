package rigibo.frontend.sound;

import java.util.List;

/**
 * The instruments of the music, synthesised like knocks: bars and bells without the noise of the
 * stroke.
 */
enum Instrument {
    /** A long bar, felt more than heard. */
    BASS(110, Tone.steady(110, 1, 0.55), Tone.steady(220, 0.30, 0.30), Tone.steady(330, 0.06, 0.2)),
    /** A marimba's bar: its second partial is two octaves up. */
    BAR(
            330,
            Tone.steady(330, 1, 0.32),
            Tone.steady(1320, 0.16, 0.10),
            Tone.steady(3036, 0.03, 0.03)),
    /** A small bell far away; two partials beat slowly. */
    BELL(
            660,
            Tone.steady(660, 1, 0.45),
            Tone.steady(661.3, 0.5, 0.40),
            Tone.steady(1322, 0.14, 0.20));

    private final double frequency;
    private final List<Tone> tones;

    Instrument(double frequency, Tone... tones) {
        this.frequency = frequency;
        this.tones = List.of(tones);
    }

    Sample sample() {
        return Sample.ringing(tones);
    }

    /** How many times as fast its sample is played for a frequency, Hz. */
    double pitch(double wanted) {
        return wanted / frequency;
    }
}
