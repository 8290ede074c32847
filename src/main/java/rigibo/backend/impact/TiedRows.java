package rigibo.backend.impact;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * The rows of impacts at one instant: a normal row for each point, and a tangent row behind those
 * of its pair. Velocities are those of the bodies' columns.
 */
final class TiedRows {

    private final Bodies bodies;
    private final Pairs pairs;

    /** Number of rows. */
    int count;

    /** By row: the pair, and its two bodies. */
    int[] pair = new int[16];

    int[] bodyA = new int[16];
    int[] bodyB = new int[16];

    /** By row: for a tangent, the number of its normal rows, which precede it; 0 for a normal. */
    int[] points = new int[16];

    /** By row: for a normal, the tangent row of its pair; {@link #NONE} without friction. */
    int[] tangent = new int[16];

    static final int NONE = -1;

    /** By row: its direction, and its levers in m. */
    private double[] directionX = new double[16];

    private double[] directionY = new double[16];
    private double[] leverA = new double[16];
    private double[] leverB = new double[16];

    /** By row: speed that its own unit impulse gives it, 1/kg; the speed that it aims at, m/s. */
    double[] response = new double[16];

    double[] target = new double[16];

    /** By row: its impulse, N·s; the friction coefficient of a tangent. */
    double[] impulse = new double[16];

    double[] friction = new double[16];

    /** By row: its speed before any impulse, m/s. */
    double[] speedBefore = new double[16];

    TiedRows(Bodies bodies, Pairs pairs) {
        this.bodies = bodies;
        this.pairs = pairs;
    }

    /** Adds a row along (x, y) through the midpoint of an impact's points i and j; returns it. */
    int add(int ofPair, double x, double y, Impact impact, int i, int j) {
        if (count == pair.length) {
            grow();
        }
        int row = count++;
        pair[row] = ofPair;
        bodyA[row] = pairs.bodyA[ofPair];
        bodyB[row] = pairs.bodyB[ofPair];
        points[row] = 0;
        tangent[row] = NONE;
        directionX[row] = x;
        directionY[row] = y;
        leverA[row] = lever(impact.armAX, impact.armAY, x, y, i, j);
        leverB[row] = lever(impact.armBX, impact.armBY, x, y, i, j);
        response[row] =
                impact.inverseMassA
                        + impact.inverseMassB
                        + impact.inverseInertiaA * leverA[row] * leverA[row]
                        + impact.inverseInertiaB * leverB[row] * leverB[row];
        target[row] = 0;
        impulse[row] = 0;
        friction[row] = 0;
        speedBefore[row] = speed(row);
        return row;
    }

    /** Marks a row as the tangent of the given number of normal rows before it. */
    void makeTangent(int row, int normals, double coefficient) {
        points[row] = normals;
        friction[row] = coefficient;
        Arrays.fill(tangent, row - normals, row, row);
    }

    private static double lever(double[] armX, double[] armY, double x, double y, int i, int j) {
        return ((armX[i] + armX[j]) * y - (armY[i] + armY[j]) * x) / 2;
    }

    private void grow() {
        int capacity = 2 * count;
        pair = Arrays.copyOf(pair, capacity);
        bodyA = Arrays.copyOf(bodyA, capacity);
        bodyB = Arrays.copyOf(bodyB, capacity);
        points = Arrays.copyOf(points, capacity);
        tangent = Arrays.copyOf(tangent, capacity);
        directionX = Arrays.copyOf(directionX, capacity);
        directionY = Arrays.copyOf(directionY, capacity);
        leverA = Arrays.copyOf(leverA, capacity);
        leverB = Arrays.copyOf(leverB, capacity);
        response = Arrays.copyOf(response, capacity);
        target = Arrays.copyOf(target, capacity);
        impulse = Arrays.copyOf(impulse, capacity);
        friction = Arrays.copyOf(friction, capacity);
        speedBefore = Arrays.copyOf(speedBefore, capacity);
    }

    /** Speed of B relative to A along a row, m/s. */
    double speed(int row) {
        int a = bodyA[row];
        int b = bodyB[row];
        return directionX[row] * (bodies.velocityX[b] - bodies.velocityX[a])
                + directionY[row] * (bodies.velocityY[b] - bodies.velocityY[a])
                + leverB[row] * bodies.spinOf(b)
                - leverA[row] * bodies.spinOf(a);
    }

    /** Adds to a row's impulse, N·s, and changes the velocities of its bodies. */
    void push(int row, double change) {
        impulse[row] += change;
        double x = directionX[row] * change;
        double y = directionY[row] * change;
        push(bodyA[row], -x, -y, -leverA[row] * change);
        push(bodyB[row], x, y, leverB[row] * change);
    }

    private void push(int slot, double x, double y, double turn) {
        // An infinite impulse would give an immovable body 0·∞ = NaN.
        if (!bodies.isDynamic(slot)) {
            return;
        }
        bodies.velocityX[slot] += bodies.inverseMass[slot] * x;
        bodies.velocityY[slot] += bodies.inverseMass[slot] * y;
        if (bodies.turns()) {
            bodies.spin[slot] += bodies.inverseInertia[slot] * turn;
        }
    }

    /** Largest friction impulse that the present normal impulses allow, N·s. */
    double cone(int tangent) {
        double normal = 0;
        for (int row = tangent - points[tangent]; row < tangent; row++) {
            normal += impulse[row];
        }
        return friction[tangent] * normal;
    }

    /** Speed that a unit impulse of one row gives another, 1/kg. */
    double response(int i, int j) {
        double direct = directionX[i] * directionX[j] + directionY[i] * directionY[j];
        int a = bodyA[i];
        int b = bodyB[i];
        double sum = 0;
        if (a == bodyA[j]) {
            sum += through(a, direct, leverA[i] * leverA[j]);
        }
        if (b == bodyB[j]) {
            sum += through(b, direct, leverB[i] * leverB[j]);
        }
        if (a == bodyB[j]) {
            sum -= through(a, direct, leverA[i] * leverB[j]);
        }
        if (b == bodyA[j]) {
            sum -= through(b, direct, leverB[i] * leverA[j]);
        }
        return sum;
    }

    private double through(int slot, double direct, double levers) {
        if (!bodies.isDynamic(slot)) {
            return 0;
        }
        double turning = bodies.turns() ? bodies.inverseInertia[slot] * levers : 0;
        return bodies.inverseMass[slot] * direct + turning;
    }
}
