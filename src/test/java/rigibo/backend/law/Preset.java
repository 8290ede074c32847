package rigibo.backend.law;

import rigibo.backend.setup.Accuracy;

import java.util.Arrays;

/** The presets by name. */
public enum Preset {
    DRAFT(Accuracy.DRAFT),
    GAME(Accuracy.GAME),
    FINE(Accuracy.FINE),
    EXACT(Accuracy.EXACT);

    public final Accuracy accuracy;

    Preset(Accuracy accuracy) {
        this.accuracy = accuracy;
    }

    static Preset of(Accuracy accuracy) {
        return Arrays.stream(values())
                .filter(preset -> preset.accuracy.equals(accuracy))
                .findFirst()
                .orElseThrow();
    }
}
