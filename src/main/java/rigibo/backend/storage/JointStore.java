package rigibo.backend.storage;

import rigibo.backend.setup.JointKind;

import java.util.Arrays;

/**
 * Columns of the joints, one slot each, and the list of joints of each body. A slot whose {@link
 * #bodyA} is {@link #NONE} is empty. The store exists only where joints are declared.
 */
public final class JointStore {

    public static final int NONE = -1;

    /** Most rows of a joint; {@link #force} keeps the force of each. */
    public static final int ROWS = 7;

    /** Number of parameters besides those that several kinds of joints share. */
    public static final int PARAMETERS = 6;

    /** Parameter of a distance joint: its length, m. */
    public static final int LENGTH = 0;

    /**
     * Parameters of a motor joint: velocity in m/s and rad/s, greatest force in N and torque in
     * N·m.
     */
    public static final int VELOCITY_X = 0;

    public static final int VELOCITY_Y = 1;
    public static final int ANGULAR_VELOCITY = 2;
    public static final int MOST_FORCE = 3;
    public static final int MOST_TORQUE = 4;

    /** Parameters of a mouse joint: its target, m; {@link #MOST_FORCE} as well. */
    public static final int TARGET_X = 0;

    public static final int TARGET_Y = 1;

    /**
     * Parameters of a gear joint: its ratio, and the sum of coordinates that it keeps constant, rad
     * or m.
     */
    public static final int RATIO = 0;

    public static final int CONSTANT = 1;

    /**
     * Parameters of a pulley joint, besides {@link #RATIO}: the length of the rope and its two
     * fixed points, m.
     */
    public static final int ROPE = 1;

    public static final int GROUND_AX = 2;
    public static final int GROUND_AY = 3;
    public static final int GROUND_BX = 4;
    public static final int GROUND_BY = 5;

    private static final int FIRST_CAPACITY = 16;
    private static final JointKind[] KINDS = JointKind.values();

    public final Slots slots = new Slots();

    /** Ordinal of the {@link JointKind}. */
    public int[] kind = new int[FIRST_CAPACITY];

    public int[] bodyA = new int[FIRST_CAPACITY];
    public int[] bodyB = new int[FIRST_CAPACITY];

    /** For a gear joint: the two joints that it couples; otherwise {@link #NONE}. */
    public int[] firstGeared = new int[FIRST_CAPACITY];

    public int[] secondGeared = new int[FIRST_CAPACITY];

    /** Whether the two bodies collide with each other. */
    public boolean[] meets = new boolean[FIRST_CAPACITY];

    /** Anchors in m and axes in rad, each in its body's frame. */
    public double[] anchorAX = new double[FIRST_CAPACITY];

    public double[] anchorAY = new double[FIRST_CAPACITY];
    public double[] axisA = new double[FIRST_CAPACITY];
    public double[] anchorBX = new double[FIRST_CAPACITY];
    public double[] anchorBY = new double[FIRST_CAPACITY];
    public double[] axisB = new double[FIRST_CAPACITY];

    /** Parameters, indexed by number, then by slot. */
    public final double[][] parameter = new double[PARAMETERS][FIRST_CAPACITY];

    /** Limits of the joint's coordinate in rad or m, and elasticity of the rebound at them. */
    public double[] lower = new double[FIRST_CAPACITY];

    public double[] upper = new double[FIRST_CAPACITY];
    public double[] elasticity = new double[FIRST_CAPACITY];

    /** Speed in rad/s or m/s, and greatest torque in N·m or force in N. */
    public double[] motorSpeed = new double[FIRST_CAPACITY];

    public double[] motorMost = new double[FIRST_CAPACITY];

    /**
     * The spring as stated, then the values that follow: stiffness in N/m or N·m/rad, damping in
     * N·s/m or N·m·s/rad.
     */
    public double[] hertz = new double[FIRST_CAPACITY];

    public double[] dampingRatio = new double[FIRST_CAPACITY];
    public double[] stiffness = new double[FIRST_CAPACITY];
    public double[] damping = new double[FIRST_CAPACITY];

    /** Force in N and torque in N·m at which the joint breaks. */
    public double[] breakForce = new double[FIRST_CAPACITY];

    public double[] breakTorque = new double[FIRST_CAPACITY];

    /** Force at the end of the last step, N or N·m, indexed by row, then by slot. */
    public final double[][] force = new double[ROWS][FIRST_CAPACITY];

    /** Mean reaction on B in the last step: force in N, and torque about B's anchor in N·m. */
    public double[] reactionX = new double[FIRST_CAPACITY];

    public double[] reactionY = new double[FIRST_CAPACITY];
    public double[] reactionTurn = new double[FIRST_CAPACITY];

    /** Magnitude of the mean force in the last step without its impacts, N. */
    public double[] pull = new double[FIRST_CAPACITY];

    /** Joints that this step visits, since one of their bodies is awake; in slot order. */
    public final Found active = new Found();

    /** By body: the first joint of its list. By joint: the next one in the lists of A and of B. */
    private int[] firstOf = new int[FIRST_CAPACITY];

    private int[] next = new int[2 * FIRST_CAPACITY];
    private final Room room = new Room(FIRST_CAPACITY, this::visitColumns);

    /** An empty store. */
    public JointStore() {
        Arrays.fill(firstOf, NONE);
    }

    /** Passes every column to a visitor, which may replace the arrays. */
    public void visitColumns(ColumnVisitor visitor) {
        JointColumns.visit(this, visitor);
    }

    /** Makes room for a number of slots. */
    public void reserve(int slotCount) {
        room.reserve(slotCount);
    }

    /** Whether a joint is attached to a point of the world besides its bodies. */
    public boolean holdsOnToPlace(int joint) {
        JointKind of = KINDS[kind[joint]];
        return of == JointKind.MOUSE || of == JointKind.PULLEY;
    }

    /** Adds a joint between two bodies to the lists of both, and returns its slot. */
    public int add(JointKind of, int a, int b) {
        int joint = slots.take();
        room.hold(joint);
        kind[joint] = of.ordinal();
        bodyA[joint] = a;
        bodyB[joint] = b;
        firstGeared[joint] = NONE;
        secondGeared[joint] = NONE;
        for (double[] column : parameter) {
            column[joint] = 0;
        }
        rest(joint);
        link(joint);
        return joint;
    }

    /** Clears the forces that a joint carried. */
    public void rest(int joint) {
        for (double[] column : force) {
            column[joint] = 0;
        }
        reactionX[joint] = 0;
        reactionY[joint] = 0;
        reactionTurn[joint] = 0;
        pull[joint] = 0;
    }

    /** Removes a joint from both lists and frees its slot. */
    public void remove(int joint) {
        unlink(joint, bodyA[joint], 0);
        unlink(joint, bodyB[joint], 1);
        bodyA[joint] = NONE;
        slots.giveBack(joint);
    }

    /** Rebuilds the lists after the columns were read from a snapshot. */
    public void derive() {
        Arrays.fill(firstOf, NONE);
        for (int i = 0; i < slots.freeCount; i++) {
            bodyA[slots.free[i]] = NONE;
        }
        for (int joint : slots.occupied()) {
            link(joint);
        }
    }

    /** The kind of a joint. */
    public JointKind kindOf(int joint) {
        return KINDS[kind[joint]];
    }

    /** The first joint of a body, or {@link #NONE}. */
    public int firstOf(int body) {
        return body < firstOf.length ? firstOf[body] : NONE;
    }

    /** The next joint in a body's list after this one, or {@link #NONE}. */
    public int nextOf(int joint, int body) {
        return next[2 * joint + (bodyA[joint] == body ? 0 : 1)];
    }

    /** The other body of a joint. */
    public int other(int joint, int body) {
        return bodyA[joint] == body ? bodyB[joint] : bodyA[joint];
    }

    /** Whether a joint keeps two bodies from colliding. */
    public boolean keepApart(int a, int b) {
        for (int j = firstOf(a); j != NONE; j = nextOf(j, a)) {
            if (!meets[j] && other(j, a) == b) {
                return true;
            }
        }
        return false;
    }

    /** Whether a joint that has rows holds a body. */
    public boolean holds(Bodies bodies, int body) {
        for (int j = firstOf(body); j != NONE; j = nextOf(j, body)) {
            if (hasRows(bodies, j)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a joint acts: its kind has rows, a body of it is dynamic, and neither is disabled.
     */
    public boolean hasRows(Bodies bodies, int joint) {
        int a = bodyA[joint];
        int b = bodyB[joint];
        return kind[joint] != JointKind.FILTER.ordinal()
                && (bodies.isDynamic(a) || bodies.isDynamic(b))
                && !bodies.isDisabled(a)
                && !bodies.isDisabled(b);
    }

    private void link(int joint) {
        int high = Math.max(bodyA[joint], bodyB[joint]);
        if (firstOf.length <= high) {
            int before = firstOf.length;
            firstOf = Arrays.copyOf(firstOf, 2 * (high + 1));
            Arrays.fill(firstOf, before, firstOf.length, NONE);
        }
        if (next.length <= 2 * joint + 1) {
            next = Arrays.copyOf(next, 4 * (joint + 1));
        }
        next[2 * joint] = firstOf[bodyA[joint]];
        firstOf[bodyA[joint]] = joint;
        next[2 * joint + 1] = firstOf[bodyB[joint]];
        firstOf[bodyB[joint]] = joint;
    }

    private void unlink(int joint, int body, int side) {
        int after = next[2 * joint + side];
        if (firstOf[body] == joint) {
            firstOf[body] = after;
            return;
        }
        int before = firstOf[body];
        while (nextOf(before, body) != joint) {
            before = nextOf(before, body);
        }
        next[2 * before + (bodyA[before] == body ? 0 : 1)] = after;
    }

    /** Distance of a joint's anchor from the centre of mass of its body A, m. */
    public double armA(int joint) {
        return length(anchorAX[joint], anchorAY[joint]);
    }

    /** Distance of a joint's anchor from the centre of mass of its body B, m. */
    public double armB(int joint) {
        return length(anchorBX[joint], anchorBY[joint]);
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }

    /** Whether a distance joint has a greatest length, as a rope has. */
    public boolean isRope(int joint) {
        return upper[joint] < Double.POSITIVE_INFINITY;
    }

    /** Length of a distance joint if it is taut: the greatest of a rope, that of a rod, m. */
    public double tautLength(int joint) {
        return isRope(joint) ? upper[joint] : parameter[LENGTH][joint];
    }
}
