package rigibo.frontend.puzzle.session;

/** Who makes the clicks. */
public enum Hand {
    PLAYER,
    /** A stored solution, which earns nothing. */
    SOLUTION,
    /** The player's try that is over, shown again. */
    REPLAY,
    /** A recording, watched from its start to its end. */
    RECORDING
}
