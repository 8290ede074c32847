package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;

import java.util.Arrays;

/**
 * How far joints may lead bodies off their straight paths within a step. A plank of a vibrating
 * bridge may go up although its velocity points down, into a flyer just above it. The distance
 * cannot be known beforehand; the bound is twice the distance by which joints led the body, or one
 * near it, in the last step.
 */
final class Sway {

    /** Bound on the way in a step, as a multiple of that in the last one. */
    private static final double FARTHEST = 2;

    /** Number of joints from a body to those that count as near it. */
    private static final int NEAR = 2;

    private final Bodies bodies;

    /** Null if joints are not declared. */
    private final JointStore joints;

    /** Whether the accelerations of this step were found; most steps ask for none. */
    private boolean areKnown;

    /** By body: acceleration by its joints, m/s² and rad/s². */
    private double[] x = new double[16];

    private double[] y = new double[16];
    private double[] turn = new double[16];

    /** By body: greatest acceleration of a point of it, or of a body near it, m/s². */
    private double[] most = new double[16];

    /** By body: greatest speed against a body that it is joined to, or of a body near it, m/s. */
    private double[] speed = new double[16];

    /** Scratch: either quantity without the bodies one joint farther away. */
    private double[] nearer = new double[16];

    Sway(DataStorage data) {
        bodies = data.bodies;
        joints = data.joints;
    }

    /** Starts a step. */
    void begin() {
        areKnown = false;
    }

    /** Whether there are joints that may lead bodies off. */
    boolean isAny() {
        return joints != null && joints.active.count > 0;
    }

    /** How far joints may lead a body off its straight path in a step of dt seconds, m. */
    double reach(int slot, double dt) {
        if (joints == null || joints.firstOf(slot) == JointStore.NONE) {
            return 0;
        }
        if (!areKnown) {
            find();
            areKnown = true;
        }
        return FARTHEST * Math.min(most[slot] * dt / 2, speed[slot]) * dt;
    }

    private void find() {
        int high = bodies.slots.high;
        if (x.length < high) {
            int capacity = bodies.type.length;
            x = new double[capacity];
            y = new double[capacity];
            turn = new double[capacity];
            most = new double[capacity];
            speed = new double[capacity];
            nearer = new double[capacity];
        }
        Arrays.fill(x, 0, high, 0);
        Arrays.fill(y, 0, high, 0);
        Arrays.fill(turn, 0, high, 0);
        Arrays.fill(most, 0, high, 0);
        Arrays.fill(speed, 0, high, 0);
        for (int i = 0; i < joints.active.count; i++) {
            int joint = joints.active.numbers[i];
            push(joint, joints.bodyA[joint], joints.anchorAX[joint], joints.anchorAY[joint], -1);
            push(joint, joints.bodyB[joint], joints.anchorBX[joint], joints.anchorBY[joint], 1);
        }
        for (int i = 0; i < joints.active.count; i++) {
            int joint = joints.active.numbers[i];
            measure(joints.bodyA[joint]);
            measure(joints.bodyB[joint]);
            compare(joints.bodyA[joint], joints.bodyB[joint]);
        }
        for (int i = 0; i < NEAR; i++) {
            spread(most, high);
            spread(speed, high);
        }
    }

    /** Adds the acceleration of a body by a joint's reaction in the last step. */
    private void push(int joint, int slot, double anchorX, double anchorY, double sign) {
        double forceX = sign * joints.reactionX[joint];
        double forceY = sign * joints.reactionY[joint];
        x[slot] += bodies.inverseMass[slot] * forceX;
        y[slot] += bodies.inverseMass[slot] * forceY;
        if (bodies.turns()) {
            double leverX = bodies.cos[slot] * anchorX - bodies.sin[slot] * anchorY;
            double leverY = bodies.sin[slot] * anchorX + bodies.cos[slot] * anchorY;
            double torque = leverX * forceY - leverY * forceX + sign * joints.reactionTurn[joint];
            turn[slot] += bodies.inverseInertia[slot] * torque;
        }
    }

    private void measure(int slot) {
        if (bodies.isDynamic(slot)) {
            double ax = x[slot] + bodies.accelerationX[slot];
            double ay = y[slot] + bodies.accelerationY[slot];
            double turning = bodies.turns() ? bodies.sweepRadius[slot] * Math.abs(turn[slot]) : 0;
            most[slot] = Math.sqrt(ax * ax + ay * ay) + turning;
        }
    }

    /** Measures how fast two bodies move against each other. */
    private void compare(int a, int b) {
        double x = bodies.velocityX[b] - bodies.velocityX[a];
        double y = bodies.velocityY[b] - bodies.velocityY[a];
        double against = Math.sqrt(x * x + y * y);
        speed[a] = Math.max(speed[a], against);
        speed[b] = Math.max(speed[b], against);
    }

    /** Hands a quantity on to the bodies one joint farther away. */
    private void spread(double[] quantity, int high) {
        System.arraycopy(quantity, 0, nearer, 0, high);
        for (int i = 0; i < joints.active.count; i++) {
            int a = joints.bodyA[joints.active.numbers[i]];
            int b = joints.bodyB[joints.active.numbers[i]];
            if (bodies.isDynamic(a) && bodies.isDynamic(b)) {
                quantity[a] = Math.max(quantity[a], nearer[b]);
                quantity[b] = Math.max(quantity[b], nearer[a]);
            }
        }
    }
}
