package rigibo.frontend.scene.accuracy;

import rigibo.backend.setup.Accuracy;

import java.util.Arrays;
import java.util.Optional;

/** The positions of the dial, from the fastest to the most accurate. */
public enum Preset {
    DRAFT(Accuracy.DRAFT, "fast and plausible", "1 mm"),
    GAME(Accuracy.GAME, "the game's", "0.1 mm"),
    FINE(Accuracy.FINE, "measurable", "1 µm"),
    EXACT(Accuracy.EXACT, "as good as doubles get", "1 nm");

    private final Accuracy accuracy;
    private final String purpose;
    private final String tolerance;

    Preset(Accuracy accuracy, String purpose, String tolerance) {
        this.accuracy = accuracy;
        this.purpose = purpose;
        this.tolerance = tolerance;
    }

    /** What a pool is set to. */
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

    /** What it is, in a line. */
    String help() {
        String substeps = accuracy.substeps() == 1 ? " substep" : " substeps";
        return purpose + ": " + accuracy.substeps() + substeps + ", impacts within " + tolerance;
    }
}
