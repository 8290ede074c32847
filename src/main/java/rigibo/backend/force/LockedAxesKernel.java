package rigibo.backend.force;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/** Clears accelerations along locked axes, where the lock bears every force. */
public final class LockedAxesKernel {

    private final Bodies bodies;
    private final Roster roster;

    /** A kernel for a storage in which axes are locked. */
    public LockedAxesKernel(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Clears them for all awake bodies, after all steady forces were added. */
    public void hold(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            bodies.holdAxes(roster.awake[i], bodies.accelerationX, bodies.accelerationY);
        }
    }
}
