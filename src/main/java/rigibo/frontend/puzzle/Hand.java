package rigibo.frontend.puzzle;

/** Who makes the clicks. */
enum Hand {
    PLAYER,
    /** A stored solution's: earns nothing. */
    SOLUTION,
    /** The player's of a try that is over. */
    REPLAY,
    /** Those of a recording that is watched from its start to its end. */
    RECORDING
}
