package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Roster;

/**
 * Makes every awake body that is kept from moving along an axis part of a pile, whether it touches
 * anything or not: impacts in flight know of one mass for all directions.
 */
public final class LockedBodies {

    private final Bodies bodies;
    private final Roster roster;

    /** Over the bodies of a storage in which axes are locked. */
    public LockedBodies(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
    }

    /** Piles all that a step moves. */
    public void pile(double dt) {
        for (int i = 0; i < roster.awakeCount; i++) {
            int slot = roster.awake[i];
            if (bodies.isDynamic(slot) && bodies.isHeldByAxis(slot)) {
                bodies.piled[slot] = true;
            }
        }
    }
}
