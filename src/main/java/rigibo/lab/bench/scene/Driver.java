package rigibo.lab.bench.scene;

import rigibo.lab.engine.World;

/**
 * Moves or strikes some of a scene's bodies before each step, in the same way in every engine.
 * Drivers are records, so that equal scenes have equal fingerprints.
 */
public sealed interface Driver permits Driver.None, Drum, Tray, Belt, Striker {

    /** The driver of a scene that nothing drives. */
    record None() implements Driver {
        @Override
        public void drive(World world, int made) {}
    }

    /**
     * Prepares the next step.
     *
     * @param made steps made so far
     */
    void drive(World world, int made);
}
