package rigibo.backend.contact.joint;

import rigibo.backend.storage.JointStore;

/**
 * The forces of an island's joints in the first kick of a step and in the last one. The first is
 * made at true places, while the mean forces of a step are wrong if its substeps do not follow the
 * island. The last tells which of them go on.
 */
final class KickForces {

    private final JointStore joints;
    private final PackedJoints packed;

    /** By joint of the packed island: its force in the first kick and in the last one, N. */
    private double[] first = new double[16];

    private double[] last = new double[16];

    /** By joint: its impulse in a kick, N·s. */
    private double[] lastX = new double[16];

    private double[] lastY = new double[16];

    private boolean isDone;

    KickForces(JointStore joints, PackedJoints packed) {
        this.joints = joints;
        this.packed = packed;
    }

    /** Begins with an island that was just packed. */
    void begin() {
        isDone = false;
        if (first.length < packed.count) {
            first = new double[packed.slot.length];
            last = new double[packed.slot.length];
            lastX = new double[packed.slot.length];
            lastY = new double[packed.slot.length];
        }
    }

    /** Adds the impulses of a kick of a length in s to those of the step. */
    void add(JointResults results, double kick) {
        // Impacts before it are no part of it.
        for (int i = 0; i < packed.count; i++) {
            lastX[i] = -packed.givenX[i];
            lastY[i] = -packed.givenY[i];
        }
        results.add();
        for (int i = 0; i < packed.count; i++) {
            double x = lastX[i] + packed.givenX[i];
            double y = lastY[i] + packed.givenY[i];
            last[i] = Math.sqrt(x * x + y * y) / kick;
            first[i] = isDone ? first[i] : last[i];
        }
        isDone = true;
    }

    /**
     * Replaces the mean pulls that are stored by those of the first kick where these are greater.
     */
    void tellGreater() {
        for (int i = 0; i < packed.count; i++) {
            int joint = packed.slot[i];
            joints.pull[joint] = Math.max(joints.pull[joint], first[i]);
        }
    }

    /**
     * Replaces them by those of the last kick where these are less: what has gone does not last.
     */
    void tellLess() {
        for (int i = 0; i < packed.count; i++) {
            int joint = packed.slot[i];
            joints.pull[joint] = Math.min(joints.pull[joint], last[i]);
        }
    }
}
