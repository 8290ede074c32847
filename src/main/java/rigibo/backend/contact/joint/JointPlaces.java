package rigibo.backend.contact.joint;

import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.PairTolerances;

/**
 * Measures the places of joints' rows, and the sizes of their joints, at the poses that were taken
 * last. A joint is measured once as long as its rows are asked one after the other.
 */
final class JointPlaces {

    /** Allowed error of a place, as a share of the joint's arms and of the tolerance. */
    static final double MISSED = 1e-5;

    /** Round-off of a place, as a share of the joint's arms: about 4 ulp. */
    private static final double PLACE_ROUND_OFF = 4e-16;

    private static final JointKind[] KINDS = JointKind.values();

    private final Bodies bodies;
    private final JointStore joints;
    private final NeutralRows rows;
    private final PackedJoints packed;
    private final JointGeometry geometry;
    private final JointGeometry other;

    /** The joint that was measured last: its number in the island, its slot, its offsets. */
    private int joint = NeutralRows.NONE;

    private int slot;
    private int a;
    private int b;

    JointPlaces(DataStorage data, NeutralRows rows, PackedJoints packed, Poses poses) {
        bodies = data.bodies;
        joints = data.jointsOrNone();
        this.rows = rows;
        this.packed = packed;
        geometry = new JointGeometry(data.bodies, joints, poses);
        other = new JointGeometry(data.bodies, joints, poses);
    }

    /** Discards measurements, since poses have been taken anew. */
    void measureAnew() {
        joint = NeutralRows.NONE;
    }

    /** Place of a row, m or rad: the error of an equation, or the gap of a limit. */
    double of(int row) {
        measure(row);
        return switch (rows.part[row]) {
            case JointRows.X -> ofX();
            case JointRows.Y -> geometry.dy;
            case JointRows.ANGLE -> geometry.angle;
            case JointRows.LOWER -> geometry.coordinate(slot) - joints.lower[slot];
            default -> ofUpper();
        };
    }

    private void measure(int row) {
        if (joint != rows.joint[row]) {
            joint = rows.joint[row];
            slot = packed.slot[joint];
            a = packed.offsetA[joint];
            b = packed.offsetB[joint];
            geometry.measure(slot, a, b);
        }
    }

    private double ofX() {
        return switch (KINDS[joints.kind[slot]]) {
            case REVOLUTE, WELD -> geometry.dx;
            case DISTANCE -> geometry.along - joints.parameter[JointStore.LENGTH][slot];
            case GEAR -> ofGear();
            default -> geometry.across();
        };
    }

    private double ofGear() {
        int first = joints.firstGeared[slot];
        int second = joints.secondGeared[slot];
        geometry.measure(first, packed.offset(joints.bodyA[first]), a);
        other.measure(second, packed.offset(joints.bodyA[second]), b);
        return geometry.gearError(slot, other);
    }

    private double ofUpper() {
        return joints.kind[slot] == JointKind.PULLEY.ordinal()
                ? geometry.ropeLeft(slot, a, b)
                : joints.upper[slot] - geometry.coordinate(slot);
    }

    /** Distance of the anchors along the axis of a row's joint, m. */
    double along(int row) {
        of(row);
        return geometry.along;
    }

    /** Size of a row's joint, in units of the row, m or rad. */
    double size(int row) {
        return lengthOf(row) / rows.unit[row];
    }

    /** Size of a row's joint, m. */
    double lengthOf(int row) {
        measure(row);
        return size();
    }

    /**
     * Size of the joint that was measured last, m; errors are shares of it. It is the sum of the
     * movable bodies' arms and of the distance between the anchors, but at least a body's width,
     * since a wheel is held at its centre. The distance of a fixed body's centre does not count.
     */
    double size() {
        double size = Math.abs(geometry.dx) + Math.abs(geometry.dy);
        if (a != 0) {
            size += Math.abs(geometry.armAX) + Math.abs(geometry.armAY);
        }
        if (b != 0) {
            size += Math.abs(geometry.armBX) + Math.abs(geometry.armBY);
        }
        return Math.max(size, PairTolerances.width(bodies, joints.bodyA[slot], joints.bodyB[slot]));
    }

    /** Round-off of the place of the joint that was measured last, m. */
    double roundOff() {
        return PLACE_ROUND_OFF
                * (size()
                        + Math.abs(geometry.armAX)
                        + Math.abs(geometry.armAY)
                        + Math.abs(geometry.armBX)
                        + Math.abs(geometry.armBY));
    }
}
