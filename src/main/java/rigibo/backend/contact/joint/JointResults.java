package rigibo.backend.contact.joint;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Found;
import rigibo.backend.storage.JointStore;

/** The impulses of joints: kept from kick to kick, summed over a step, and stored at its end. */
final class JointResults {

    private final Bodies bodies;
    private final JointStore joints;
    private final Found broken;
    private final PackedJoints packed;
    private final NeutralRows rows;

    /**
     * By joint: the vectors from B's centre, and from A's, to the point at which the joint holds B,
     * m.
     */
    private double[] armBX = new double[16];

    private double[] armBY = new double[16];
    private double[] armAX = new double[16];
    private double[] armAY = new double[16];

    JointResults(DataStorage data, PackedJoints packed, NeutralRows rows) {
        bodies = data.bodies;
        joints = data.jointsOrNone();
        broken = data.broken;
        this.packed = packed;
        this.rows = rows;
    }

    /** Stores the points at which joints hold B, at poses that were taken. */
    void keepArms(Poses poses) {
        if (armBX.length < packed.count) {
            int capacity = packed.slot.length;
            armBX = new double[capacity];
            armBY = new double[capacity];
            armAX = new double[capacity];
            armAY = new double[capacity];
        }
        for (int i = 0; i < packed.count; i++) {
            int joint = packed.slot[i];
            int a = joints.bodyA[joint];
            int b = joints.bodyB[joint];
            double x = joints.anchorBX[joint];
            double y = joints.anchorBY[joint];
            double cos = poses.cos(b, packed.offsetB[i]);
            double sin = poses.sin(b, packed.offsetB[i]);
            armBX[i] = cos * x - sin * y;
            armBY[i] = sin * x + cos * y;
            double movedX = poses.movedX(packed.offsetB[i]) - poses.movedX(packed.offsetA[i]);
            double movedY = poses.movedY(packed.offsetB[i]) - poses.movedY(packed.offsetA[i]);
            armAX[i] = armBX[i] + bodies.x[b] - bodies.x[a] + movedX;
            armAY[i] = armBY[i] + bodies.y[b] - bodies.y[a] + movedY;
        }
    }

    /** Keeps the impulses of a kick, and adds them to those of the step. */
    void add() {
        for (int i = 0; i < packed.count * JointStore.ROWS; i++) {
            packed.impulse[i] = 0;
        }
        for (int row = 0; row < rows.count; row++) {
            int joint = rows.joint[row];
            if (joint != NeutralRows.NONE) {
                packed.impulse[joint * JointStore.ROWS + rows.part[row]] = rows.impulse[row];
                add(row, joint);
            }
        }
    }

    /** Adds the impulses of an impact to those of the step. */
    void addImpact() {
        for (int i = 0; i < packed.count; i++) {
            packed.struckX[i] -= packed.givenX[i];
            packed.struckY[i] -= packed.givenY[i];
        }
        for (int row = 0; row < rows.count; row++) {
            if (rows.joint[row] != NeutralRows.NONE) {
                add(row, rows.joint[row]);
            }
        }
        for (int i = 0; i < packed.count; i++) {
            packed.struckX[i] += packed.givenX[i];
            packed.struckY[i] += packed.givenY[i];
        }
    }

    /** Impulse on B; if B cannot be moved, the opposite of that on A. */
    private void add(int row, int joint) {
        int b = packed.offsetB[joint];
        boolean isOfB = b != 0;
        int body = isOfB ? b : packed.offsetA[joint];
        double sign = isOfB ? rows.impulse[row] : -rows.impulse[row];
        for (int i = 0; i < rows.bodies[row]; i++) {
            if (rows.body[row * NeutralRows.BODIES + i] == body) {
                int at = row * NeutralRows.DERIVATIVES + 3 * i;
                double x = sign * rows.derivative[at];
                double y = sign * rows.derivative[at + 1];
                double armX = isOfB ? armBX[joint] : armAX[joint];
                double armY = isOfB ? armBY[joint] : armAY[joint];
                packed.givenX[joint] += x;
                packed.givenY[joint] += y;
                packed.givenTurn[joint] += sign * rows.derivative[at + 2] - (armX * y - armY * x);
            }
        }
    }

    /** Stores the mean forces of a step of dt seconds. */
    void tell(double dt) {
        for (int i = 0; i < packed.count; i++) {
            int joint = packed.slot[i];
            joints.reactionX[joint] = packed.givenX[i] / dt;
            joints.reactionY[joint] = packed.givenY[i] / dt;
            joints.reactionTurn[joint] = packed.givenTurn[i] / dt;
            double x = packed.givenX[i] - packed.struckX[i];
            double y = packed.givenY[i] - packed.struckY[i];
            joints.pull[joint] = Math.sqrt(x * x + y * y) / dt;
        }
    }

    /** Stores the forces of the last kick, given its length in s. */
    void store(double lastKick) {
        for (int i = 0; i < packed.count; i++) {
            int joint = packed.slot[i];
            double sum = Math.abs(packed.givenX[i]) + Math.abs(packed.givenY[i]);
            sum += Math.abs(packed.givenTurn[i]);
            for (int row = 0; row < JointStore.ROWS; row++) {
                double force = packed.impulse[i * JointStore.ROWS + row] / lastKick;
                joints.force[row][joint] = force;
                sum += Math.abs(force);
            }
            if (!(sum < Double.POSITIVE_INFINITY)) {
                // Forces that are not finite would spoil every later step.
                joints.rest(joint);
            }
            noteBreak(joint);
        }
    }

    /** Records which joints broke, by their mean forces. */
    void noteBreaks() {
        for (int i = 0; i < packed.count; i++) {
            noteBreak(packed.slot[i]);
        }
    }

    private void noteBreak(int joint) {
        double x = joints.reactionX[joint];
        double y = joints.reactionY[joint];
        double force = joints.breakForce[joint];
        if (x * x + y * y > force * force
                || Math.abs(joints.reactionTurn[joint]) > joints.breakTorque[joint]) {
            broken.add(joint);
        }
    }
}
