package rigibo.backend.setup;

/**
 * The eight stages of a step, in order; {@code StepReport.nanos} tells the time of each.
 *
 * <pre>{@code
 * pool.clock(System::nanoTime);
 * long nanoseconds = pool.step(1.0 / 60).nanos(StepStage.CONTACT);
 * }</pre>
 */
public enum StepStage {
    /** Takes in the removals, additions and wake-ups since the last step. */
    ACCEPT,
    /** Turns the declared effects into accelerations. */
    EFFECTS,
    /** Finds candidate pairs: bodies whose fixtures overlap. */
    BROADPHASE,
    /** Computes the manifolds, and sorts bodies into those in flight and those in piles. */
    CLASSIFY,
    /** Moves the bodies in flight and resolves their impacts in time order. */
    FLIGHT,
    /** Solves the piles, island by island, in substeps. */
    CONTACT,
    /** Puts islands at rest to sleep. */
    REST,
    /** Quarantines bodies whose state is not finite, and gathers statistics and sensor events. */
    REPORT
}
