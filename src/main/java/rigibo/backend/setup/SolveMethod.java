package rigibo.backend.setup;

/**
 * How an island of touching bodies got its answer in a step.
 *
 * <pre>{@code
 * int islands = pool.report().islands(SolveMethod.PASSES); // of the last step
 * }</pre>
 */
public enum SolveMethod {
    /** It rested on what its contacts carried already: nothing was solved. */
    AT_REST,
    /** All its rows at once, by elimination. */
    ELIMINATION,
    /** Contact by contact, in passes over them in every substep. */
    PASSES
}
