package rigibo.backend.contact.joint;

import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.JointStore;

import java.util.Arrays;

/**
 * How the lengths of stiff springs change by the curvature of the bodies' ways in a drift. Stiff
 * springs act with their force at its end: one whose bodies circle each other would be stretched in
 * each drift by as much as they move apart along their tangents.
 */
final class BentSprings {

    private static final int REVOLUTE = JointKind.REVOLUTE.ordinal();
    private static final int DISTANCE = JointKind.DISTANCE.ordinal();

    /** How often the impulse of a spring that has not acted yet is estimated. */
    private static final int TIMES = 4;

    private final JointStore joints;
    private final NeutralRows rows;
    private final PackedJoints packed;
    private final Poses poses;
    private final JointGeometry geometry;

    private int count;

    /** By stiff spring: its row, and the unit vector along which it acts. */
    private int[] row = new int[4];

    private double[] axisX = new double[4];
    private double[] axisY = new double[4];

    BentSprings(
            JointStore joints,
            NeutralRows rows,
            PackedJoints packed,
            Poses poses,
            JointGeometry geometry) {
        this.joints = joints;
        this.rows = rows;
        this.packed = packed;
        this.poses = poses;
        this.geometry = geometry;
    }

    /** Begins with rows of which none is written. */
    void begin() {
        count = 0;
    }

    /** Notes a finished row of a stiff spring whose joint is measured. */
    void note(int stiff) {
        if (joints.kind[packed.slot[rows.joint[stiff]]] == REVOLUTE) {
            return;
        }
        if (count == row.length) {
            row = Arrays.copyOf(row, 2 * count);
            axisX = Arrays.copyOf(axisX, 2 * count);
            axisY = Arrays.copyOf(axisY, 2 * count);
        }
        row[count] = stiff;
        axisX[count] = geometry.axisX;
        axisY[count] = geometry.axisY;
        count++;
    }

    /**
     * Changes the targets of the rows that were noted, at present poses, for a drift in s after a
     * kick that is {@code share} times as long as the last one.
     */
    void bend(double drift, double share) {
        if (count == 0) {
            return;
        }
        poses.take(drift);
        for (int i = 0; i < count; i++) {
            int joint = rows.joint[row[i]];
            geometry.measure(packed.slot[joint], packed.offsetA[joint], packed.offsetB[joint]);
            bend(i, drift, share * packed.impulseOf(joint, JointRows.SPRING));
        }
        poses.take(0);
    }

    /** Bends a spring whose joint is measured after the drift, given its last impulse, N·s. */
    private void bend(int i, double drift, double impulse) {
        int bent = row[i];
        double straight = rows.target[bent];
        rows.target[bent] = target(i, straight, drift, rows.response[bent] * impulse);
        for (int time = 0; impulse == 0 && time < TIMES; time++) {
            // A spring that has not acted yet will do what it does alone.
            double change = rows.response[bent] * (rows.target[bent] - rows.speed(bent));
            change /= rows.give[bent] + rows.response[bent];
            rows.target[bent] = target(i, straight, drift, change);
        }
    }

    /** Target with curvature, given that without and the change of speed by the kick, m/s. */
    private double target(int i, double straight, double drift, double change) {
        int slot = packed.slot[rows.joint[row[i]]];
        double x = geometry.dx + drift * change * axisX[i];
        double y = geometry.dy + drift * change * axisY[i];
        double then =
                joints.kind[slot] == DISTANCE
                        ? Math.sqrt(x * x + y * y) - joints.parameter[JointStore.LENGTH][slot]
                        : x * geometry.axisX + y * geometry.axisY;
        double stiffness = joints.stiffness[slot];
        double strength = joints.damping[slot] + Math.abs(drift) * stiffness;
        double now = -straight * strength / stiffness;
        double curved = then - now - drift * (rows.speed(row[i]) + change);
        return straight - stiffness * curved / strength;
    }
}
