package rigibo.backend;

import rigibo.backend.setup.Accuracy;

/** The presets by name. */
enum Presets {
    DRAFT(Accuracy.DRAFT),
    GAME(Accuracy.GAME),
    FINE(Accuracy.FINE),
    EXACT(Accuracy.EXACT);

    final Accuracy accuracy;

    Presets(Accuracy accuracy) {
        this.accuracy = accuracy;
    }
}
