package rigibo.backend.storage;

/** What happens to the content of a column when a step has ended. */
public enum Role {
    /** Later steps depend on it: it is written into snapshots and enters the state's hash. */
    SAVED,
    /**
     * Follows from saved columns, or is computed again where it is unknown, as in a restored pool.
     */
    DERIVED,
    /** Written in each step before it is read; between steps it may hold anything. */
    SCRATCH
}
