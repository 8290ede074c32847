package rigibo.backend.setup;

/**
 * How overlap is removed.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withCorrection(Correction.SOFT));
 * }</pre>
 */
public enum Correction {
    /** Not at all: overlap stays as it is. */
    NONE,
    /** A strongly damped spring pushes the bodies apart; its velocity is removed afterwards. */
    SOFT
}
