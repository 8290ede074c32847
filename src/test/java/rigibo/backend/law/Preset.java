package rigibo.backend.law;

import rigibo.backend.setup.Accuracy;

/** The presets by name. */
enum Preset {
    DRAFT(Accuracy.DRAFT),
    GAME(Accuracy.GAME),
    FINE(Accuracy.FINE),
    EXACT(Accuracy.EXACT);

    final Accuracy accuracy;

    Preset(Accuracy accuracy) {
        this.accuracy = accuracy;
    }
}
