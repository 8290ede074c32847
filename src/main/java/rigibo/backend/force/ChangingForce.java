package rigibo.backend.force;

/**
 * A force that varies along the path with position, velocity or time. One class per effect;
 * evaluated body by body, because each body has its own substeps and its own impacts in between.
 */
interface ChangingForce {

    /** Adds this force's accelerations of a body at an instant. */
    void add(Instant instant);
}
