package rigibo.backend.storage;

/** What becomes of a column's content when a step has ended. */
public enum Role {
    /** The future depends on it: it is written into snapshots and folded into the state's hash. */
    SAVED,
    /** Follows from what is saved, or is sought anew where it is unknown: restored pools do so. */
    DERIVED,
    /** Written in a step before the step reads it: between steps it may hold anything. */
    SCRATCH
}
