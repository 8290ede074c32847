package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/**
 * What moves or strikes some of a scene's bodies before each step, the same way in every engine.
 * Records, so that equal scenes have equal fingerprints.
 */
public sealed interface Driver permits Undriven, Drum, Tray, Belt, Striker {

    /** Leaves all bodies alone. */
    Driver NONE = new Undriven();

    /**
     * Prepares the next step.
     *
     * @param made steps made so far
     */
    void drive(World world, int made);
}
