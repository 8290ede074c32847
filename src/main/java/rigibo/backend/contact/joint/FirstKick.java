package rigibo.backend.contact.joint;

import rigibo.backend.storage.JointStore;

/**
 * The forces of an island's joints in the first kick of a step. It is made at true places, while
 * the mean forces of a step are wrong if its substeps do not follow the island.
 */
final class FirstKick {

    private final JointStore joints;
    private final PackedJoints packed;

    /** By joint of the packed island: its force, N. */
    private double[] x = new double[16];

    private double[] y = new double[16];

    private boolean isDone;

    FirstKick(JointStore joints, PackedJoints packed) {
        this.joints = joints;
        this.packed = packed;
    }

    /** Begins with an island that was just packed. */
    void begin() {
        isDone = false;
        if (x.length < packed.count) {
            x = new double[packed.slot.length];
            y = new double[packed.slot.length];
        }
    }

    /** Adds the impulses of a kick of a length in s to those of the step. */
    void add(JointResults results, double kick) {
        if (isDone) {
            results.add();
            return;
        }
        // Impacts at the start of the step are no part of it.
        for (int i = 0; i < packed.count; i++) {
            x[i] = -packed.givenX[i];
            y[i] = -packed.givenY[i];
        }
        results.add();
        for (int i = 0; i < packed.count; i++) {
            x[i] = (x[i] + packed.givenX[i]) / kick;
            y[i] = (y[i] + packed.givenY[i]) / kick;
        }
        isDone = true;
    }

    /** Replaces the mean forces that are stored by those of the kick where these are greater. */
    void tellGreater() {
        for (int i = 0; i < packed.count; i++) {
            int joint = packed.slot[i];
            double meanX = joints.reactionX[joint];
            double meanY = joints.reactionY[joint];
            if (x[i] * x[i] + y[i] * y[i] > meanX * meanX + meanY * meanY) {
                joints.reactionX[joint] = x[i];
                joints.reactionY[joint] = y[i];
            }
        }
    }
}
