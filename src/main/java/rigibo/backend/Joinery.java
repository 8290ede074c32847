package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Require;
import rigibo.backend.step.StepPlan;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointReading;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

/** Makes, changes and removes joints between steps, and wakes their bodies. */
final class Joinery {

    private final Pool pool;
    private final DataStorage data;
    private final Bodies bodies;
    private final JointStore joints;
    private final StepPlan plan;
    private final Waking waking;
    private final JointWriter writer;

    final JointReading reading;

    /** The pool must declare {@code Joints}. */
    Joinery(Pool pool, DataStorage data, StepPlan plan) {
        this.pool = pool;
        this.data = data;
        this.plan = plan;
        bodies = data.bodies;
        joints = data.joints;
        waking = new Waking(data);
        reading = new JointReading(bodies, joints);
        writer = new JointWriter(bodies, joints, reading);
    }

    /** Makes a joint between bodies of this pool and returns its slot. */
    int join(JointDefinition definition) {
        int a = definition.a().slot();
        int b = definition.b().slot();
        int joint = joints.add(definition.kind(), a, b);
        writer.write(joint, definition);
        pairAnew(a, b);
        wake(joint);
        return joint;
    }

    /** The current state of a joint as a definition. */
    JointDefinition definition(int joint) {
        return writer.read(pool, joint);
    }

    void remove(int joint) {
        wake(joint);
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        joints.remove(joint);
        pairAnew(a, b);
    }

    void settings(int joint, JointSettings settings) {
        JointDefinition changed = definition(joint).with(settings);
        writer.write(joint, changed);
        pairAnew(joints.bodyA[joint], joints.bodyB[joint]);
        wake(joint);
    }

    void target(int joint, double x, double y) {
        requireKind("target", joint, JointKind.MOUSE);
        joints.parameter[JointStore.TARGET_X][joint] = Require.finite("Joint.target x", x, "m");
        joints.parameter[JointStore.TARGET_Y][joint] = Require.finite("Joint.target y", y, "m");
        wake(joint);
    }

    void length(int joint, double metres) {
        requireKind("length", joint, JointKind.DISTANCE);
        Require.notNegative("Joint.length", metres, "m");
        joints.parameter[JointStore.LENGTH][joint] = metres;
        wake(joint);
    }

    private void requireKind(String verb, int joint, JointKind kind) {
        if (joints.kindOf(joint) != kind) {
            throw new IllegalArgumentException(
                    "Joint." + verb + " is of " + kind + " joints, was " + joints.kindOf(joint));
        }
    }

    private void wake(int joint) {
        waking.wake(joints.bodyA[joint]);
        waking.wake(joints.bodyB[joint]);
        data.roster.isStale = true;
    }

    /** Makes or removes the pairs of two bodies: a joint can stop them from colliding. */
    private void pairAnew(int a, int b) {
        if (plan.broadphase() == null || bodies.isDisabled(a) || bodies.isDisabled(b)) {
            return;
        }
        if (joints.keepApart(a, b)) {
            forgetPairs(a, b);
        } else {
            plan.broadphase().refit(a);
        }
    }

    private void forgetPairs(int a, int b) {
        int pair = bodies.firstPair[a];
        while (pair != Pairs.NONE) {
            int after = data.pairs.nextOf(pair, a);
            if (data.pairs.other(pair, a) == b) {
                pool.contacts().ended.cut(pair);
                plan.broadphase().forgetPair(pair);
            }
            pair = after;
        }
    }
}
