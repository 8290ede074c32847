package rigibo.backend.setup;

/**
 * What is done about overlap.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withCorrection(Correction.SOFT));
 * }</pre>
 */
public enum Correction {
    /** Nothing: overlap stays as it is. */
    NONE,
    /** A strongly damped spring pushes apart, and its velocity is taken out again. */
    SOFT
}
