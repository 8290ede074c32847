package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/**
 * Makes every awake body with a locked axis part of a pile, whether it touches anything or not,
 * since impacts in flight assume the same mass in all directions.
 */
public final class LockedBodies {

    private final Bodies bodies;
    private final Roster roster;

    /** The storage must hold locked axes. */
    public LockedBodies(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Piles all bodies with a locked axis that this step moves. */
    public void pile(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot) && bodies.isHeldByAxis(slot)) {
                bodies.piled[slot] = true;
            }
        }
    }
}
