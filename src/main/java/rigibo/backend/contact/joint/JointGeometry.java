package rigibo.backend.contact.joint;

import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.JointStore;

import java.util.Arrays;

/** The geometry of a joint at given poses: arms, axis, coordinate. */
final class JointGeometry {

    private static final int DISTANCE = JointKind.DISTANCE.ordinal();
    private static final int REVOLUTE = JointKind.REVOLUTE.ordinal();

    private static final int WELD = JointKind.WELD.ordinal();

    private final Bodies bodies;
    private final JointStore joints;
    private final Poses poses;

    /** By joint: the angle of the axis in A's frame, rad, whose cosine and sine are stored. */
    private double[] knownAxis = new double[0];

    private double[] axisCos = new double[0];
    private double[] axisSin = new double[0];

    /** Vectors from the centres of mass to the anchors, and from A's anchor to B's, m. */
    double armAX;

    double armAY;
    double armBX;
    double armBY;
    double dx;
    double dy;

    /**
     * Unit vector of the axis: A's, or for a distance joint from anchor to anchor; unused by hinges
     * and welds.
     */
    double axisX;

    double axisY;

    /** Angle of B's axis relative to A's, rad, and distance of the anchors along the axis, m. */
    double angle;

    double along;

    JointGeometry(Bodies bodies, JointStore joints, Poses poses) {
        this.bodies = bodies;
        this.joints = joints;
        this.poses = poses;
    }

    /** Measures a joint whose bodies have these offsets in the motions. */
    void measure(int joint, int offsetA, int offsetB) {
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        double cosA = poses.cos(a, offsetA);
        double sinA = poses.sin(a, offsetA);
        double cosB = poses.cos(b, offsetB);
        double sinB = poses.sin(b, offsetB);
        armAX = cosA * joints.anchorAX[joint] - sinA * joints.anchorAY[joint];
        armAY = sinA * joints.anchorAX[joint] + cosA * joints.anchorAY[joint];
        armBX = cosB * joints.anchorBX[joint] - sinB * joints.anchorBY[joint];
        armBY = sinB * joints.anchorBX[joint] + cosB * joints.anchorBY[joint];
        double movedX = poses.movedX(offsetB) - poses.movedX(offsetA);
        double movedY = poses.movedY(offsetB) - poses.movedY(offsetA);
        dx = bodies.x[b] - bodies.x[a] + movedX + (armBX - armAX);
        dy = bodies.y[b] - bodies.y[a] + movedY + (armBY - armAY);
        angle =
                poses.angle(b, offsetB)
                        + joints.axisB[joint]
                        - (poses.angle(a, offsetA) + joints.axisA[joint]);
        int kind = joints.kind[joint];
        if (kind == REVOLUTE || kind == WELD) {
            return;
        }
        if (kind == DISTANCE) {
            along = Math.sqrt(dx * dx + dy * dy);
            // If both anchors coincide, any direction will do.
            axisX = along > 0 ? dx / along : 1;
            axisY = along > 0 ? dy / along : 0;
        } else {
            // The axis as stated rather than as a sum of two angles, which would lose digits after
            // many turns.
            know(joint);
            axisX = cosA * axisCos[joint] - sinA * axisSin[joint];
            axisY = sinA * axisCos[joint] + cosA * axisSin[joint];
            along = dx * axisX + dy * axisY;
        }
    }

    /** Computes cosine and sine of a joint's axis, unless they are stored. */
    private void know(int joint) {
        if (knownAxis.length <= joint) {
            int before = knownAxis.length;
            int capacity = joints.axisA.length;
            knownAxis = Arrays.copyOf(knownAxis, capacity);
            axisCos = Arrays.copyOf(axisCos, capacity);
            axisSin = Arrays.copyOf(axisSin, capacity);
            Arrays.fill(knownAxis, before, capacity, Double.NaN);
        }
        if (knownAxis[joint] != joints.axisA[joint]) {
            knownAxis[joint] = joints.axisA[joint];
            axisCos[joint] = Angle.cos(knownAxis[joint]);
            axisSin[joint] = Angle.sin(knownAxis[joint]);
        }
    }

    /**
     * The coordinate to which limits, motor and spring of the joint refer: rad for a hinge,
     * otherwise m.
     */
    double coordinate(int joint) {
        return joints.kind[joint] == REVOLUTE ? angle : along;
    }

    /** Distance of B's anchor from the axis, m. */
    double across() {
        return dy * axisX - dx * axisY;
    }

    /** Distance of B's anchor from the target of a mouse joint, m. */
    double fromTargetX(int joint, int offsetB) {
        double away = bodies.x[joints.bodyB[joint]] - joints.parameter[JointStore.TARGET_X][joint];
        return away + poses.movedX(offsetB) + armBX;
    }

    double fromTargetY(int joint, int offsetB) {
        double away = bodies.y[joints.bodyB[joint]] - joints.parameter[JointStore.TARGET_Y][joint];
        return away + poses.movedY(offsetB) + armBY;
    }

    /** Vector from the point over which a pulley's rope runs to the anchor on A or on B, m. */
    double ropeX(int joint, int offset, boolean isOfA) {
        int body = isOfA ? joints.bodyA[joint] : joints.bodyB[joint];
        int ground = isOfA ? JointStore.GROUND_AX : JointStore.GROUND_BX;
        double away = bodies.x[body] - joints.parameter[ground][joint];
        return away + poses.movedX(offset) + (isOfA ? armAX : armBX);
    }

    double ropeY(int joint, int offset, boolean isOfA) {
        int body = isOfA ? joints.bodyA[joint] : joints.bodyB[joint];
        int ground = isOfA ? JointStore.GROUND_AY : JointStore.GROUND_BY;
        double away = bodies.y[body] - joints.parameter[ground][joint];
        return away + poses.movedY(offset) + (isOfA ? armAY : armBY);
    }

    /** q₁ + ratio·q₂ − constant of a gear whose two joints this and another geometry measured. */
    double gearError(int gear, JointGeometry second) {
        return coordinate(joints.firstGeared[gear])
                + joints.parameter[JointStore.RATIO][gear]
                        * second.coordinate(joints.secondGeared[gear])
                - joints.parameter[JointStore.CONSTANT][gear];
    }

    /** Length by which the rope of the pulley that was measured is slack, m. */
    double ropeLeft(int pulley, int offsetA, int offsetB) {
        double ax = ropeX(pulley, offsetA, true);
        double ay = ropeY(pulley, offsetA, true);
        double bx = ropeX(pulley, offsetB, false);
        double by = ropeY(pulley, offsetB, false);
        return joints.parameter[JointStore.ROPE][pulley]
                - Math.sqrt(ax * ax + ay * ay)
                - joints.parameter[JointStore.RATIO][pulley] * Math.sqrt(bx * bx + by * by);
    }
}
