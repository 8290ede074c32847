package rigibo.lab.hardcase;

import rigibo.backend.setup.Accuracy;

/** The presets of accuracy, from the fastest to the most exact. */
public enum Preset {
    DRAFT(Accuracy.DRAFT),
    GAME(Accuracy.GAME),
    FINE(Accuracy.FINE),
    EXACT(Accuracy.EXACT);

    private final Accuracy accuracy;

    Preset(Accuracy accuracy) {
        this.accuracy = accuracy;
    }

    public Accuracy accuracy() {
        return accuracy;
    }
}
