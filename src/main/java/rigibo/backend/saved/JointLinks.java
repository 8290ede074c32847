package rigibo.backend.saved;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.JointStore;

/** Rejects joints from a snapshot with impossible kinds, bodies, couplings or numbers. */
final class JointLinks {

    private final Bodies bodies;
    private final JointStore joints;
    private final boolean[] isJoint;

    private JointLinks(Bodies bodies, JointStore joints) {
        this.bodies = bodies;
        this.joints = joints;
        isJoint = new boolean[joints.slots.high];
    }

    /**
     * Checks every joint and the order in which they were added.
     *
     * @throws IllegalArgumentException naming what is wrong
     */
    static void require(Bodies bodies, JointStore joints, int[] order) {
        JointLinks links = new JointLinks(bodies, joints);
        for (int joint : joints.slots.occupied()) {
            links.isJoint[joint] = true;
        }
        for (int joint : joints.slots.occupied()) {
            links.requireJoint(joint);
        }
        links.requireOrder(order);
    }

    private void requireJoint(int joint) {
        int kinds = JointKind.values().length;
        Require.within("a joint's kind", joints.kind[joint], 0, kinds - 1);
        requireBody(joint, joints.bodyA[joint]);
        requireBody(joint, joints.bodyB[joint]);
        if (joints.bodyA[joint] == joints.bodyB[joint]) {
            throw wrong(joint, "must hold two bodies, was one");
        }
        if (joints.kindOf(joint) == JointKind.GEAR) {
            requireGeared(joint, joints.firstGeared[joint], joints.bodyA[joint]);
            requireGeared(joint, joints.secondGeared[joint], joints.bodyB[joint]);
        }
        requireNumbers(joint);
    }

    private void requireBody(int joint, int slot) {
        boolean isBody = slot >= 0 && slot < bodies.slots.high && bodies.isBody(slot);
        if (!isBody) {
            throw wrong(joint, "must hold bodies, was slot " + slot);
        }
    }

    private void requireGeared(int joint, int other, int driven) {
        boolean isGeared = other >= 0 && other < isJoint.length && isJoint[other];
        if (!isGeared || joints.bodyB[other] != driven) {
            throw wrong(joint, "must couple a joint of a body of its own, was slot " + other);
        }
    }

    private void requireNumbers(int joint) {
        for (int i = 0; i < JointStore.PARAMETERS; i++) {
            boolean mayBeEndless = i == JointStore.MOST_FORCE || i == JointStore.MOST_TORQUE;
            double value = joints.parameter[i][joint];
            if (!(mayBeEndless && value == Double.POSITIVE_INFINITY)) {
                Require.finite("a joint's parameter", value, "m, rad or N");
            }
        }
        for (double[] row : joints.force) {
            Require.finite("a joint's force", row[joint], "N");
        }
        Require.finite("a joint's reactionX", joints.reactionX[joint], "N");
        Require.finite("a joint's reactionY", joints.reactionY[joint], "N");
        Require.finite("a joint's reactionTurn", joints.reactionTurn[joint], "N·m");
        Require.notNegative("a joint's pull", joints.pull[joint], "N");
        Require.notNegative("a joint's stiffness", joints.stiffness[joint], "N/m");
        Require.notNegative("a joint's damping", joints.damping[joint], "N·s/m");
    }

    private void requireOrder(int[] order) {
        if (order.length != joints.slots.inUse()) {
            throw new IllegalArgumentException(
                    "the order of the joints must name "
                            + joints.slots.inUse()
                            + " joints, was "
                            + order.length);
        }
        for (int slot : order) {
            if (slot < 0 || slot >= isJoint.length || !isJoint[slot]) {
                throw new IllegalArgumentException(
                        "the order of the joints must name each joint once, was slot " + slot);
            }
            isJoint[slot] = false;
        }
    }

    private static IllegalArgumentException wrong(int joint, String what) {
        return new IllegalArgumentException("a joint " + what + ", joint slot " + joint);
    }
}
