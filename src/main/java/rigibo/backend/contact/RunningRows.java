package rigibo.backend.contact;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/**
 * Surfaces that run, such as a conveyor's: friction aims at their speed. Both outlines run
 * counter-clockwise, so that at the contact their speeds add.
 */
final class RunningRows {

    private final Bodies bodies;
    private final Pairs pairs;
    private final Rows rows;

    RunningRows(DataStorage data, Rows rows) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.rows = rows;
    }

    /** Writes the speeds of the packed island. */
    void begin() {
        for (int row = 0; row < rows.count; row++) {
            int pair = rows.pair[row];
            rows.running[row] =
                    bodies.surfaceSpeed[pairs.bodyA[pair]] + bodies.surfaceSpeed[pairs.bodyB[pair]];
            rows.surface[row] = rows.running[row];
            rows.isAnyRunning |= rows.running[row] != 0;
        }
    }
}
