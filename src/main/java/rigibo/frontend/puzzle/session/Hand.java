package rigibo.frontend.puzzle.session;

/** The origin of the clicks. */
public enum Hand {
    PLAYER,
    /** A stored solution, which earns no prize. */
    SOLUTION,
    /** The player's finished try, shown again. */
    REPLAY,
    /** A recording, watched from its start to its end. */
    RECORDING
}
