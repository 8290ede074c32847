package rigibo.backend.setup;

/** How an island of touching bodies got its answer in a step. */
public enum SolveMethod {
    /** It rested on what its contacts carried already: nothing was solved. */
    AT_REST,
    /** All its rows at once, by elimination. */
    ELIMINATION,
    /** All its rows at once, by splitting them from their bounds. */
    SPLITTING,
    /** Row by row, in passes over all rows in every substep. */
    PASSES
}
