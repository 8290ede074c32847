package rigibo.frontend.puzzle.rules;

/** The state of a game: running, won or lost. */
public enum Outcome {
    RUNNING,
    WON,
    LOST
}
