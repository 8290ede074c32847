package rigibo.backend.rest;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Roster;
import rigibo.backend.storage.Waking;

/**
 * Makes every joined body that is awake part of a pile, whether it touches anything or not: what a
 * joint holds follows no path of its own.
 */
public final class JointedBodies {

    private final Bodies bodies;
    private final Roster roster;
    private final JointStore joints;
    private final Waking waking;

    /** Awake bodies whose joints are listed. */
    private int listed;

    /** Over the bodies and joints of a storage, in which joints are declared. */
    public JointedBodies(DataStorage data) {
        bodies = data.bodies;
        roster = data.roster;
        joints = data.joints;
        waking = new Waking(data);
    }

    /** Lists the joints that a step looks at. Who sleeps beside somebody awake wakes. */
    public void pile(double dt) {
        joints.active.clear();
        listed = 0;
        list();
    }

    /**
     * Lists the joints of those who have been woken within the step since: one bone of a sleeper
     * that is struck would leave the others without it.
     */
    public void pileWoken(double dt) {
        if (listed < roster.awakeCount) {
            list();
        }
    }

    private void list() {
        // The list grows while it is read: who wakes has joints as well.
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
