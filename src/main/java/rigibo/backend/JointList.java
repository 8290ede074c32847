package rigibo.backend;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The joints of a pool in the order in which they were joined. Only the pool changes the list. */
final class JointList extends AbstractList<Joint> {

    private final List<Joint> joints = new ArrayList<>();
    private Joint[] bySlot = new Joint[16];

    void append(Joint joint) {
        if (joint.slot() >= bySlot.length) {
            bySlot = Arrays.copyOf(bySlot, 2 * (joint.slot() + 1));
        }
        bySlot[joint.slot()] = joint;
        joints.add(joint);
        modCount++;
    }

    void drop(Joint joint) {
        bySlot[joint.slot()] = null;
        joints.remove(joint);
        modCount++;
    }

    /** The joint of a slot that is in use. */
    Joint atSlot(int slot) {
        return bySlot[slot];
    }

    @Override
    public int size() {
        return joints.size();
    }

    @Override
    public Joint get(int index) {
        return joints.get(index);
    }
}
