package rigibo.backend.storage;

import rigibo.backend.setup.JointKind;

import java.util.Arrays;

/**
 * Columns of the joints, one slot each, and for each body the list of its joints. A slot whose
 * {@link #bodyA} is {@link #NONE} is empty. There is a store only where joints are declared.
 */
public final class JointStore {

    public static final int NONE = -1;

    /** Rows that a joint can have, each with the force it carried in {@link #force}. */
    public static final int ROWS = 7;

    /** Numbers beside those that joints of several kinds have. */
    public static final int PARAMETERS = 6;

    /** Of a distance joint: its length, m. */
    public static final int LENGTH = 0;

    /** Of a motor joint: velocity in m/s and rad/s, force in N and torque in N·m. */
    public static final int VELOCITY_X = 0;

    public static final int VELOCITY_Y = 1;
    public static final int ANGULAR_VELOCITY = 2;
    public static final int MOST_FORCE = 3;
    public static final int MOST_TORQUE = 4;

    /** Of a mouse joint: the target, m; {@link #MOST_FORCE} too. */
    public static final int TARGET_X = 0;

    public static final int TARGET_Y = 1;

    /** Of a gear joint: its ratio, and the sum that stays, rad or m. */
    public static final int RATIO = 0;

    public static final int CONSTANT = 1;

    /** Of a pulley joint, beside {@link #RATIO}: the length of the rope and its two points, m. */
    public static final int ROPE = 1;

    public static final int GROUND_AX = 2;
    public static final int GROUND_AY = 3;
    public static final int GROUND_BX = 4;
    public static final int GROUND_BY = 5;

    private static final int FIRST_CAPACITY = 16;
    private static final JointKind[] KINDS = JointKind.values();

    public final Slots slots = new Slots();

    /** The ordinal of its {@link JointKind}. */
    public int[] kind = new int[FIRST_CAPACITY];

    public int[] bodyA = new int[FIRST_CAPACITY];
    public int[] bodyB = new int[FIRST_CAPACITY];

    /** Of a gear the two joints it couples, else {@link #NONE}. */
    public int[] firstGeared = new int[FIRST_CAPACITY];

    public int[] secondGeared = new int[FIRST_CAPACITY];

    /** Whether the two bodies meet each other. */
    public boolean[] meets = new boolean[FIRST_CAPACITY];

    /** Where it holds its bodies, in their own frames: m and rad. */
    public double[] anchorAX = new double[FIRST_CAPACITY];

    public double[] anchorAY = new double[FIRST_CAPACITY];
    public double[] axisA = new double[FIRST_CAPACITY];
    public double[] anchorBX = new double[FIRST_CAPACITY];
    public double[] anchorBY = new double[FIRST_CAPACITY];
    public double[] axisB = new double[FIRST_CAPACITY];

    /** By number, then by slot. */
    public final double[][] parameter = new double[PARAMETERS][FIRST_CAPACITY];

    /** Limits of the coordinate in rad or m, and how it rebounds from them. */
    public double[] lower = new double[FIRST_CAPACITY];

    public double[] upper = new double[FIRST_CAPACITY];
    public double[] elasticity = new double[FIRST_CAPACITY];

    /** rad/s or m/s, N·m or N. */
    public double[] motorSpeed = new double[FIRST_CAPACITY];

    public double[] motorMost = new double[FIRST_CAPACITY];

    /** The spring as stated, and what follows: N/m or N·m/rad, and N·s/m or N·m·s/rad. */
    public double[] hertz = new double[FIRST_CAPACITY];

    public double[] dampingRatio = new double[FIRST_CAPACITY];
    public double[] stiffness = new double[FIRST_CAPACITY];
    public double[] damping = new double[FIRST_CAPACITY];

    /** N and N·m. */
    public double[] breakForce = new double[FIRST_CAPACITY];

    public double[] breakTorque = new double[FIRST_CAPACITY];

    /** By row, then by slot: N or N·m that held when the last step ended. */
    public final double[][] force = new double[ROWS][FIRST_CAPACITY];

    /** Mean of the last step on B: N, and N·m about its anchor. */
    public double[] reactionX = new double[FIRST_CAPACITY];

    public double[] reactionY = new double[FIRST_CAPACITY];
    public double[] reactionTurn = new double[FIRST_CAPACITY];

    /** Joints with an awake body, in the order of their slots: those that this step looks at. */
    public final Found active = new Found();

    /** Joints that broke in this step. */
    public final Found broken = new Found();

    /** By body the first joint of its list; by joint the next one in the lists of A and of B. */
    private int[] firstOf = new int[FIRST_CAPACITY];

    private int[] next = new int[2 * FIRST_CAPACITY];
    private final Room room = new Room(FIRST_CAPACITY, this::visitColumns);

    /** An empty store. */
    public JointStore() {
        Arrays.fill(firstOf, NONE);
    }

    /** Shows every column to a visitor, which may put others in their place. */
    public void visitColumns(ColumnVisitor visitor) {
        JointColumns.visit(this, visitor);
    }

    /** Makes room for so many slots. */
    public void reserve(int slotCount) {
        room.reserve(slotCount);
    }

    /** Whether a joint holds on to a place in the world beside its bodies. */
    public boolean holdsOnToPlace(int joint) {
        JointKind of = KINDS[kind[joint]];
        return of == JointKind.MOUSE || of == JointKind.PULLEY;
    }

    /** A free slot of a joint between two bodies, which is in the lists of both. */
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

    /** Forgets what a joint carried. */
    public void rest(int joint) {
        for (double[] column : force) {
            column[joint] = 0;
        }
        reactionX[joint] = 0;
        reactionY[joint] = 0;
        reactionTurn[joint] = 0;
    }

    /** Takes a joint out of both lists. */
    public void remove(int joint) {
        unlink(joint, bodyA[joint], 0);
        unlink(joint, bodyB[joint], 1);
        bodyA[joint] = NONE;
        slots.giveBack(joint);
    }

    /** Writes the lists of joints that were just read. */
    public void derive() {
        Arrays.fill(firstOf, NONE);
        for (int i = 0; i < slots.freeCount; i++) {
            bodyA[slots.free[i]] = NONE;
        }
        for (int joint : slots.occupied()) {
            link(joint);
        }
    }

    /** Of which kind a joint is. */
    public JointKind kindOf(int joint) {
        return KINDS[kind[joint]];
    }

    /** The first joint of a body, or {@link #NONE}. */
    public int firstOf(int body) {
        return body < firstOf.length ? firstOf[body] : NONE;
    }

    /** The next joint in the list of a body that is in this one, or {@link #NONE}. */
    public int nextOf(int joint, int body) {
        return next[2 * joint + (bodyA[joint] == body ? 0 : 1)];
    }

    /** The other body of a joint. */
    public int other(int joint, int body) {
        return bodyA[joint] == body ? bodyB[joint] : bodyA[joint];
    }

    /** Whether a joint keeps two bodies from meeting. */
    public boolean keepApart(int a, int b) {
        for (int j = firstOf(a); j != NONE; j = nextOf(j, a)) {
            if (!meets[j] && other(j, a) == b) {
                return true;
            }
        }
        return false;
    }

    /** Whether a body is held by a joint that has rows. */
    public boolean holds(Bodies bodies, int body) {
        for (int j = firstOf(body); j != NONE; j = nextOf(j, body)) {
            if (hasRows(bodies, j)) {
                return true;
            }
        }
        return false;
    }

    /** Whether a joint does anything: it has rows, and both of its bodies take part. */
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
}
