package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Roster;
import rigibo.backend.storage.Waking;

/**
 * Makes every awake body with a joint part of a pile, whether it touches anything or not, since a
 * joint can deflect it from a path of free flight at any time.
 */
public final class JointedBodies {

    private final Bodies bodies;
    private final Roster roster;
    private final JointStore joints;
    private final Waking waking;

    /** The storage must hold joints. */
    public JointedBodies(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
        joints = data.joints;
        waking = new Waking(data);
    }

    /** Lists the joints of this step, and wakes sleepers that are joined to an awake body. */
    public void pile(double dt) {
        Found active = joints.active;
        active.clear();
        // The list grows while it is read, since woken bodies can have joints too.
        for (int i = 0; i < roster.awakeCount; i++) {
            pile(roster.awake[i], active);
        }
        active.sort();
    }

    private void pile(int slot, Found active) {
        if (!bodies.isDynamic(slot)) {
            return;
        }
        for (int j = joints.firstOf(slot); j != JointStore.NONE; j = joints.nextOf(j, slot)) {
            if (joints.hasRows(bodies, j)) {
                bodies.piled[slot] = true;
                int other = joints.other(j, slot);
                boolean isPassive = !bodies.isDynamic(other);
                if (!isPassive && !bodies.awake[other]) {
                    waking.wakeIntoPile(other);
                }
                if (isPassive || joints.bodyA[j] == slot) {
                    active.add(j);
                }
            }
        }
    }
}
