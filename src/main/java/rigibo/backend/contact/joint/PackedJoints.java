package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;

import java.util.Arrays;

/** The joints of one island: their slots, and the offsets of their bodies in the motions. */
final class PackedJoints {

    /** Numbers of a joint that are stored, to be restored. */
    private static final int KEPT = JointStore.ROWS + 5;

    private final JointStore joints;
    private final Islands islands;
    private final RowBuilder builder;

    int count;
    int[] slot = new int[16];
    int[] offsetA = new int[16];
    int[] offsetB = new int[16];

    /** By joint and row: the impulses of the last kick and of the step, N·s or N·m·s. */
    double[] impulse = new double[16 * JointStore.ROWS];

    /** By joint: the impulse on B in the step, N·s, and its moment about the anchor, N·m·s. */
    double[] givenX = new double[16];

    double[] givenY = new double[16];
    double[] givenTurn = new double[16];

    /** By joint: the part of that impulse which impacts gave, N·s. */
    double[] struckX = new double[16];

    double[] struckY = new double[16];

    /** A stored copy of these impulses. */
    private double[] kept = new double[16];

    PackedJoints(DataStorage data, RowBuilder builder) {
        joints = data.jointsOrNone();
        islands = data.islands;
        this.builder = builder;
    }

    /** Packs the joints of an island whose bodies are packed, for a first kick of a length in s. */
    void pack(int island, double firstKick) {
        int from = islands.jointStart[island];
        count = islands.jointStart[island + 1] - from;
        if (slot.length < count) {
            int capacity = 2 * count;
            slot = new int[capacity];
            offsetA = new int[capacity];
            offsetB = new int[capacity];
            impulse = new double[capacity * JointStore.ROWS];
            givenX = new double[capacity];
            givenY = new double[capacity];
            givenTurn = new double[capacity];
            struckX = new double[capacity];
            struckY = new double[capacity];
        }
        for (int i = 0; i < count; i++) {
            int joint = islands.joints[from + i];
            slot[i] = joint;
            offsetA[i] = builder.offset(joints.bodyA[joint]);
            offsetB[i] = builder.offset(joints.bodyB[joint]);
            for (int row = 0; row < JointStore.ROWS; row++) {
                impulse[i * JointStore.ROWS + row] = firstKick * joints.force[row][joint];
            }
        }
        Arrays.fill(givenX, 0, count, 0);
        Arrays.fill(givenY, 0, count, 0);
        Arrays.fill(givenTurn, 0, count, 0);
        Arrays.fill(struckX, 0, count, 0);
        Arrays.fill(struckY, 0, count, 0);
    }

    /** Stores the impulses, so that they can be restored. */
    void keep() {
        if (kept.length < slot.length * KEPT) {
            kept = new double[slot.length * KEPT];
        }
        int at = count * JointStore.ROWS;
        System.arraycopy(impulse, 0, kept, 0, at);
        System.arraycopy(givenX, 0, kept, at, count);
        System.arraycopy(givenY, 0, kept, at + count, count);
        System.arraycopy(givenTurn, 0, kept, at + 2 * count, count);
        System.arraycopy(struckX, 0, kept, at + 3 * count, count);
        System.arraycopy(struckY, 0, kept, at + 4 * count, count);
    }

    /** Restores the stored impulses. */
    void recall() {
        int at = count * JointStore.ROWS;
        System.arraycopy(kept, 0, impulse, 0, at);
        System.arraycopy(kept, at, givenX, 0, count);
        System.arraycopy(kept, at + count, givenY, 0, count);
        System.arraycopy(kept, at + 2 * count, givenTurn, 0, count);
        System.arraycopy(kept, at + 3 * count, struckX, 0, count);
        System.arraycopy(kept, at + 4 * count, struckY, 0, count);
    }

    /** Impulse of a joint's row in the last kick, N·s or N·m·s. */
    double impulseOf(int joint, int row) {
        return impulse[joint * JointStore.ROWS + row];
    }

    /** The offset of a body in the motions. */
    int offset(int body) {
        return builder.offset(body);
    }
}
