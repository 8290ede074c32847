package rigibo.frontend.puzzle.rules;

/** How a game stands. */
public enum Outcome {
    RUNNING,
    WON,
    LOST
}
