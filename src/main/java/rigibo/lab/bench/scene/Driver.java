package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/**
 * Moves or strikes some of a scene's bodies before each step, in the same way in every engine.
 * Drivers are records, so that equal scenes have equal fingerprints.
 */
public sealed interface Driver permits Undriven, Drum, Tray, Belt, Striker {

    /** Does nothing. */
    Driver NONE = new Undriven();

    /**
     * Prepares the next step.
     *
     * @param made steps made so far
     */
    void drive(World world, int made);
}
