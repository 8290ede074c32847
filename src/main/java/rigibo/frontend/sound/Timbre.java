package rigibo.frontend.sound;

import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/**
 * The sound of a struck material by modal synthesis: a decaying sine for each vibration mode of the
 * body (Adrien, "The missing link: modal synthesis", 1991).
 *
 * @param frequency f₁ of the lowest partial of a body of 1 m, Hz
 * @param decay τ₁ of the lowest partial, s; the others' are τ₁·f₁/f, as in a material that loses
 *     the same share of energy in every cycle
 * @param contact duration of an impact, s: it excites partials by 1/(1 + (f·contact)²), so that
 *     hard materials sound bright
 * @param hiss amplitude of the impact's own noise
 * @param ratios f/f₁ of the partials, the first of them 1
 */
record Timbre(double frequency, double decay, double contact, double hiss, double... ratios) {

    /** A bar with free ends: the roots of cos x·cosh x = 1, squared, over the first. */
    private static final double[] BAR = {1, 2.757, 5.404, 8.933};

    /** A round skin: the zeros of Bessel's functions over the first. */
    private static final double[] MEMBRANE = {1, 1.594, 2.136, 2.296, 2.653};

    /**
     * A bar whose middle is cut out, as a marimba's, so that the second partial is two octaves up.
     */
    private static final double[] MARIMBA = {1, 4, 9.2};

    /** A block as long as thick, which bends, shears and stretches: no row of its own. */
    private static final double[] BLOCK = {1, 1.47, 2.09, 2.56, 3.39, 4.08};

    /** The timbre of a skin. */
    static Timbre of(Skin skin) {
        return switch (skin) {
            case RIGIBO -> new Timbre(270, 0.10, 0.0012, 0.10, MARIMBA);
            case STONE, EMBER -> new Timbre(330, 0.035, 0.0004, 0.40, BLOCK);
            case IRON -> new Timbre(390, 0.30, 0.0005, 0.10, BAR);
            case ICE -> new Timbre(820, 0.06, 0.0004, 0.25, BLOCK);
            case RUBBER -> new Timbre(120, 0.045, 0.0060, 0.04, 1, 2);
            case WOOD, GOAL -> new Timbre(200, 0.045, 0.0010, 0.20, BAR);
            case BALL -> new Timbre(150, 0.060, 0.0030, 0.08, MEMBRANE);
        };
    }

    /** A body of 1 m. */
    Sample sample() {
        List<Tone> tones = new ArrayList<>();
        for (double ratio : ratios) {
            double excited = frequency * ratio * contact;
            tones.add(Tone.steady(frequency * ratio, 1 / (1 + excited * excited), decay / ratio));
        }
        return Sample.of(tones, hiss);
    }
}
