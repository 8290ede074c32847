package rigibo.backend;

import rigibo.backend.setup.Accuracy;

/** The two accuracies that closed forms are held to. */
enum Level {
    GAME(Accuracy.GAME),
    EXACT(Accuracy.EXACT);

    final Accuracy accuracy;

    Level(Accuracy accuracy) {
        this.accuracy = accuracy;
    }

    double limit(double exact, double game) {
        return this == EXACT ? exact : game;
    }
}
