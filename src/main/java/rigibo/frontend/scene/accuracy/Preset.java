package rigibo.frontend.scene.accuracy;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Words;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The positions of the dial, from the fastest to the most accurate. */
public enum Preset {
    DRAFT(Accuracy.DRAFT, "1 mm"),
    GAME(Accuracy.GAME, "0.1 mm"),
    FINE(Accuracy.FINE, "1 µm"),
    EXACT(Accuracy.EXACT, "1 nm");

    private final Accuracy accuracy;
    private final String tolerance;

    Preset(Accuracy accuracy, String tolerance) {
        this.accuracy = accuracy;
        this.tolerance = tolerance;
    }

    /** The accuracy of this preset. */
    public Accuracy accuracy() {
        return accuracy;
    }

    /** The next one, round and round. */
    public Preset next() {
        return values()[(ordinal() + 1) % values().length];
    }

    /** The position that stands for an accuracy; none for one that was set by hand. */
    public static Optional<Preset> of(Accuracy accuracy) {
        return Arrays.stream(values()).filter(one -> one.accuracy.equals(accuracy)).findFirst();
    }

    /** Its name in links. */
    public String linked() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The position that a link names; none where there is no such. */
    public static Optional<Preset> ofLinked(String name) {
        return Arrays.stream(values()).filter(one -> one.linked().equals(name)).findFirst();
    }

    /** A line that describes it. */
    String help(Words words) {
        String purpose = words.of("preset." + linked());
        return words.of("preset.help", purpose, accuracy.substeps(), tolerance);
    }
}
