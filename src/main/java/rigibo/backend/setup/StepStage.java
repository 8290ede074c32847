package rigibo.backend.setup;

/**
 * The eight stages of a step, in their order; a report tells the time of each.
 *
 * <pre>{@code
 * pool.clock(System::nanoTime);
 * long nanoseconds = pool.step(1.0 / 60).nanos(StepStage.CONTACT);
 * }</pre>
 */
public enum StepStage {
    /** Removals, additions and wake-ups asked for since the last step. */
    ACCEPT,
    /** Declared effects become accelerations. */
    EFFECTS,
    /** Size fixtures become candidate pairs. */
    BROADPHASE,
    /** Manifolds; who is in flight and who is in a pile. */
    CLASSIFY,
    /** Bodies in flight and their impacts in time order. */
    FLIGHT,
    /** Piles: the substepped impulse resolver. */
    CONTACT,
    /** Islands fall asleep. */
    REST,
    /** Statistics. */
    REPORT
}
