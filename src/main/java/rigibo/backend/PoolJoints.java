package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.Require;
import rigibo.backend.step.StepPlan;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.JointStore;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** The joints of a pool that declares {@code Joints}: their handles, and which ones broke. */
final class PoolJoints {

    private final Pool pool;
    private final JointStore store;
    private final Joinery joinery;
    private final JointList joints = new JointList();
    private final List<JointBreak> broken = new ArrayList<>();

    /** Slots of the joints that broke in the last step. */
    private final Found brokenSlots;

    PoolJoints(Pool pool, DataStorage data, StepPlan plan) {
        this.pool = pool;
        store = data.joints;
        brokenSlots = data.broken;
        joinery = new Joinery(pool, data, plan);
    }

    /** Takes over the joints of a snapshot, in the order in which they were joined. */
    void restore(int[] order) {
        store.derive();
        for (int slot : order) {
            joints.append(new Joint(pool, slot));
        }
        // Making a definition checks the restored values.
        joints.forEach(Joint::definition);
    }

    Joint join(JointDefinition definition) {
        if (definition instanceof GearJoint gear) {
            requireOwn(gear.first());
            requireOwn(gear.second());
        }
        pool.requireOwn(definition.a());
        pool.requireOwn(definition.b());
        Joint joint = new Joint(pool, joinery.join(definition));
        joints.append(joint);
        return joint;
    }

    /** Removes a joint and the gears that couple it. */
    void remove(Joint joint) {
        int slot = requireOwn(joint).slot();
        for (Joint other : List.copyOf(joints)) {
            boolean isGear = other.kind() == JointKind.GEAR;
            if (isGear
                    && (store.firstGeared[other.slot()] == slot
                            || store.secondGeared[other.slot()] == slot)) {
                end(other);
            }
        }
        end(joint);
    }

    private void end(Joint joint) {
        joinery.remove(joint.slot());
        joints.drop(joint);
        joint.markRemoved();
    }

    /** Removes the joints of a body that is about to be removed. */
    void removeAllOf(RigidBody body) {
        int first = store.firstOf(body.slot());
        while (first != JointStore.NONE) {
            remove(joints.atSlot(first));
            first = store.firstOf(body.slot());
        }
    }

    /** Marks all joints as removed, since {@code Joints} is no longer declared. */
    void removeAll() {
        joints.forEach(Joint::markRemoved);
    }

    /** Removes the joints that broke in the last step, and records them. */
    void followBreaks() {
        broken.clear();
        for (int i = 0; i < brokenSlots.count; i++) {
            Joint joint = joints.atSlot(brokenSlots.numbers[i]);
            // A gear whose joint broke in the same step was removed with that joint.
            if (joint != null) {
                broken.add(
                        new JointBreak(
                                joint,
                                joint.definition(),
                                joint.reactionForce(),
                                joint.reactionTorque()));
                remove(joint);
            }
        }
        brokenSlots.clear();
    }

    List<JointBreak> broken() {
        return List.copyOf(broken);
    }

    List<Joint> all() {
        return Collections.unmodifiableList(joints);
    }

    List<Joint> of(int body) {
        List<Joint> found = new ArrayList<>();
        for (int j = store.firstOf(body); j != JointStore.NONE; j = store.nextOf(j, body)) {
            found.add(joints.atSlot(j));
        }
        found.sort((one, other) -> Integer.compare(joints.indexOf(one), joints.indexOf(other)));
        return found;
    }

    Joint atSlot(int slot) {
        return joints.atSlot(slot);
    }

    Joinery joinery() {
        return joinery;
    }

    int[] order() {
        return joints.stream().mapToInt(Joint::slot).toArray();
    }

    Joint requireOwn(Joint joint) {
        Require.present("joint", joint).requireAlive();
        if (joint.pool() != pool) {
            throw new IllegalArgumentException(joint + " belongs to another pool");
        }
        return joint;
    }
}
