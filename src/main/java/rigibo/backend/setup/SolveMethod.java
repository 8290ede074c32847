package rigibo.backend.setup;

/**
 * How an island of touching bodies was solved in a step.
 *
 * <pre>{@code
 * int islands = pool.report().islands(SolveMethod.PASSES); // of the last step
 * }</pre>
 */
public enum SolveMethod {
    /** Not at all: the forces that its contacts already carried keep it at rest. */
    AT_REST,
    /** By elimination: all rows at once. */
    ELIMINATION,
    /** By passes over its contacts, one after the other, in every substep. */
    PASSES
}
