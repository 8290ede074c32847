package rigibo.backend.storage;

import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.JointKind;

/** Coordinates, speeds and errors of joints at the present state of their bodies. */
public final class JointReading {

    private final Bodies bodies;
    private final JointStore joints;

    /** World vectors, m: arm from A's centre of mass to its anchor. */
    private double armAX;

    private double armAY;

    /** Arm from B's centre of mass to its anchor. */
    private double armBX;

    private double armBY;

    /** From A's anchor to B's. */
    private double dx;

    private double dy;

    /** Unit vector along the joint's axis; for a distance joint, from A's anchor to B's. */
    private double axisX;

    private double axisY;

    public JointReading(Bodies bodies, JointStore joints) {
        this.bodies = bodies;
        this.joints = joints;
    }

    private void measure(int joint) {
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        armAX = bodies.cos[a] * joints.anchorAX[joint] - bodies.sin[a] * joints.anchorAY[joint];
        armAY = bodies.sin[a] * joints.anchorAX[joint] + bodies.cos[a] * joints.anchorAY[joint];
        armBX = bodies.cos[b] * joints.anchorBX[joint] - bodies.sin[b] * joints.anchorBY[joint];
        armBY = bodies.sin[b] * joints.anchorBX[joint] + bodies.cos[b] * joints.anchorBY[joint];
        dx = bodies.x[b] - bodies.x[a] + (armBX - armAX);
        dy = bodies.y[b] - bodies.y[a] + (armBY - armAY);
        double length = Math.sqrt(dx * dx + dy * dy);
        if (isOf(joint, JointKind.DISTANCE) && length > 0) {
            axisX = dx / length;
            axisY = dy / length;
        } else {
            double cos = Angle.cos(joints.axisA[joint]);
            double sin = Angle.sin(joints.axisA[joint]);
            axisX = bodies.cos[a] * cos - bodies.sin[a] * sin;
            axisY = bodies.sin[a] * cos + bodies.cos[a] * sin;
        }
    }

    private boolean isOf(int joint, JointKind kind) {
        return joints.kind[joint] == kind.ordinal();
    }

    /** Distance of the anchors along the joint's axis, m. */
    public double translation(int joint) {
        measure(joint);
        return dx * axisX + dy * axisY;
    }

    private double angle(int joint) {
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        return bodies.angle[b] + joints.axisB[joint] - (bodies.angle[a] + joints.axisA[joint]);
    }

    /** The joint's coordinate: rad for a hinge, m for all other kinds. */
    public double coordinate(int joint) {
        return isOf(joint, JointKind.REVOLUTE) ? angle(joint) : translation(joint);
    }

    /** Rate of the coordinate, rad/s or m/s. */
    public double speed(int joint) {
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        double spinA = bodies.spinOf(a);
        double spinB = bodies.spinOf(b);
        if (isOf(joint, JointKind.REVOLUTE)) {
            return spinB - spinA;
        }
        measure(joint);
        double vx = bodies.velocityX[b] - bodies.velocityX[a];
        double vy = bodies.velocityY[b] - bodies.velocityY[a];
        vx += spinA * (armAY + dy) - spinB * armBY;
        vy += spinB * armBX - spinA * (armAX + dx);
        return vx * axisX + vy * axisY;
    }

    /** How far the anchors are from where the joint holds them, m; rad for some gears. */
    public double error(int joint) {
        measure(joint);
        return switch (joints.kindOf(joint)) {
            case REVOLUTE, WELD -> Math.sqrt(dx * dx + dy * dy);
            case PRISMATIC, WHEEL -> Math.abs(dy * axisX - dx * axisY);
            case DISTANCE -> distanceError(joint);
            case GEAR -> Math.abs(geared(joint) - joints.parameter[JointStore.CONSTANT][joint]);
            case PULLEY -> Math.max(0, rope(joint) - joints.parameter[JointStore.ROPE][joint]);
            case MOTOR, MOUSE, FILTER -> 0;
        };
    }

    /** How far a distance is beyond its limits, or a rod's from its length, m. */
    private double distanceError(int joint) {
        double length = translation(joint);
        boolean isRod =
                joints.lower[joint] == Double.NEGATIVE_INFINITY
                        && joints.upper[joint] == Double.POSITIVE_INFINITY
                        && joints.stiffness[joint] == 0
                        && joints.motorMost[joint] == 0;
        return isRod
                ? Math.abs(length - joints.parameter[JointStore.LENGTH][joint])
                : Math.max(0, Math.max(joints.lower[joint] - length, length - joints.upper[joint]));
    }

    /** q₁ + ratio·q₂, which a gear keeps constant. */
    public double geared(int joint) {
        double ratio = joints.parameter[JointStore.RATIO][joint];
        return coordinate(joints.firstGeared[joint])
                + ratio * coordinate(joints.secondGeared[joint]);
    }

    private double rope(int joint) {
        double[][] p = joints.parameter;
        int a = joints.bodyA[joint];
        int b = joints.bodyB[joint];
        double ax = bodies.x[a] + armAX - p[JointStore.GROUND_AX][joint];
        double ay = bodies.y[a] + armAY - p[JointStore.GROUND_AY][joint];
        double bx = bodies.x[b] + armBX - p[JointStore.GROUND_BX][joint];
        double by = bodies.y[b] + armBY - p[JointStore.GROUND_BY][joint];
        return Math.sqrt(ax * ax + ay * ay)
                + p[JointStore.RATIO][joint] * Math.sqrt(bx * bx + by * by);
    }

    /** Angle by which a slider or a rigid weld is turned, rad. */
    public double angleError(int joint) {
        boolean isHeld =
                isOf(joint, JointKind.PRISMATIC)
                        || isOf(joint, JointKind.WELD) && joints.stiffness[joint] == 0;
        return isHeld ? Math.abs(angle(joint)) : 0;
    }

    /** Deflection of a joint's spring from its rest position, m or rad. */
    public double strain(int joint) {
        return switch (joints.kindOf(joint)) {
            case WELD -> angle(joint);
            case DISTANCE -> translation(joint) - joints.parameter[JointStore.LENGTH][joint];
            case MOUSE -> hand(joint);
            default -> coordinate(joint);
        };
    }

    private double hand(int joint) {
        measure(joint);
        int b = joints.bodyB[joint];
        double x = bodies.x[b] + armBX - joints.parameter[JointStore.TARGET_X][joint];
        double y = bodies.y[b] + armBY - joints.parameter[JointStore.TARGET_Y][joint];
        return Math.sqrt(x * x + y * y);
    }
}
