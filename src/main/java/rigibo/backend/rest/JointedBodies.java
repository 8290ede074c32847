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

    /** Number of awake bodies whose joints are listed. */
    private int listed;

    /** The storage must hold joints. */
    public JointedBodies(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
        joints = data.joints;
        waking = new Waking(data);
    }

    /** Lists the joints of this step, and wakes sleepers that are joined to an awake body. */
    public void pile(double dt) {
        joints.active.clear();
        listed = 0;
        list();
    }

    /**
     * Lists the joints of bodies woken since then in the same step. Without them a struck sleeper
     * would go through the step without its joints, each of its bones on its own.
     */
    public void pileWoken(double dt) {
        if (listed < roster.awakeCount) {
            list();
        }
    }

    private void list() {
        // The list grows while it is read, since woken bodies can have joints too.
        for (; listed < roster.awakeCount; listed++) {
            pile(roster.awake[listed], joints.active);
        }
        joints.active.sort();
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
