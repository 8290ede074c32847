package rigibo.backend.force;

/**
 * A force that changes along a body's way, with its place, its velocity or time. One class per
 * effect; asked for single bodies, for each has its own substeps and its own impacts in between.
 */
interface ChangingForce {

    /** Adds to the accelerations of a body at an instant. */
    void add(Instant instant);
}
