package rigibo.backend.storage;

import rigibo.backend.effect.Effects;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;

/**
 * Columns of the candidate pairs: two bodies whose size fixtures overlap, and what is known of the
 * contact between them. Body A always has the lower slot. A pair sits in the lists of both its
 * bodies; columns of two values per pair are indexed {@code 2 * pair + point}. Whatever is done to
 * every column, {@link PairColumns} does.
 */
public final class Pairs {

    /** Ends a list. */
    public static final int NONE = -1;

    /**
     * In {@link #passage}: nobody has decided yet; the two meet; one is behind the other's surface;
     * one is just coming through it.
     */
    public static final int UNDECIDED = 0;

    public static final int MEETS = 1;
    public static final int PASSES = 2;
    public static final int COMES_THROUGH = 3;

    /** In {@link #beside}: the two cannot touch in this step but where they have points. */
    public static final double NOT_AWAITED = -1;

    private static final int FIRST_CAPACITY = 64;

    public final Slots slots = new Slots();
    public final PairIndex index = new PairIndex();

    /** Slots of the two bodies; {@link #NONE} in A marks an empty slot. */
    public int[] bodyA = new int[FIRST_CAPACITY];

    public int[] bodyB = new int[FIRST_CAPACITY];

    /** Slots of the two shapes, where a body has more than one; else null, and the bodies' own. */
    int[] shapesA;

    int[] shapesB;

    /** Links of the two lists the pair is in, at 2·pair for A's and 2·pair + 1 for B's. */
    public int[] next = new int[2 * FIRST_CAPACITY];

    public int[] previous = new int[2 * FIRST_CAPACITY];

    /** Unit normal from A to B, and 0, 1 or 2 points of contact. */
    public double[] normalX = new double[FIRST_CAPACITY];

    public double[] normalY = new double[FIRST_CAPACITY];

    /** Slot of the body whose face the normal stands on, or {@link #NONE}: it joins two points. */
    public int[] faceOf = new int[FIRST_CAPACITY];

    public int[] points = new int[FIRST_CAPACITY];

    /**
     * How far away points were looked for when the step before began, m; NaN where nobody looked,
     * or what was found has been changed since.
     */
    public double[] reach = new double[FIRST_CAPACITY];

    /** Per point: world place and gap in m (negative in overlap), and the id of its features. */
    public double[] pointX = new double[2 * FIRST_CAPACITY];

    public double[] pointY = new double[2 * FIRST_CAPACITY];
    public double[] separation = new double[2 * FIRST_CAPACITY];
    public int[] feature = new int[2 * FIRST_CAPACITY];

    /**
     * Where the bodies were when the points were measured, m: the centre of the one that is not
     * dynamic, or else halfway between both.
     */
    public double[] middleX = new double[FIRST_CAPACITY];

    public double[] middleY = new double[FIRST_CAPACITY];

    /** Per point: which one of the manifold before it continues, 0 or 1, or {@link #NONE}. */
    public int[] former = new int[2 * FIRST_CAPACITY];

    /** Per point: the force (N) that held at the end of the last step; starts the next one. */
    public double[] normalForce = new double[2 * FIRST_CAPACITY];

    /** Per point: the force (N) carried of late, averaged over the last seconds. */
    public double[] load = new double[2 * FIRST_CAPACITY];

    /**
     * Of declared effects only, else null: mixed from the two materials, and the friction force (N)
     * and rolling torque (N·m) that held at the end of the last step, which mean nothing where the
     * points carry nothing.
     */
    public double[] friction;

    public double[] elasticity;
    public double[] frictionForce;
    public double[] rollingTorque;

    /** Normal impulse of the last step, impacts included, N·s. */
    public double[] impulse = new double[FIRST_CAPACITY];

    /** Impacts of the pair in this step. */
    public int[] impacts = new int[FIRST_CAPACITY];

    /** Whether what is driven presses into the other body so deep that it presses no further. */
    public boolean[] crushed = new boolean[FIRST_CAPACITY];

    /** Whether the pair presses without bouncing: part of a pile. */
    public boolean[] resting = new boolean[FIRST_CAPACITY];

    /** Whether the pair touched in this step and in the one before. */
    public boolean[] touching = new boolean[FIRST_CAPACITY];

    public boolean[] touchedBefore = new boolean[FIRST_CAPACITY];

    /**
     * Of pairs with a shape that is solid on one side alone: whether the two meet; null where no
     * shape is such.
     */
    public int[] passage;

    /**
     * Of pairs with an edge of a chain that have no point: the gap in m between the two where one
     * may come over the edge within the reach that was looked, else {@link #NOT_AWAITED}; null
     * likewise.
     */
    public double[] beside;

    /** The pairs this step has to look at: those with an awake body. */
    public int[] active = new int[FIRST_CAPACITY];

    public int activeCount;

    /** The step in which a pair was last listed as active, and the number of this step. */
    int[] activeStep = new int[FIRST_CAPACITY];

    private int step;

    private Effects effects;

    private final Set<Need> asked = EnumSet.noneOf(Need.class);

    private final Room room = new Room(FIRST_CAPACITY, this::visitColumns);

    /** Creates the columns that a set of effects needs. */
    public Pairs(Effects effects) {
        declare(effects);
    }

    /** Shows every column to a visitor, which may put others in their place. */
    public void visitColumns(ColumnVisitor visitor) {
        PairColumns.visit(this, visitor);
    }

    /**
     * Makes the columns of newly declared effects and drops those of effects no longer declared.
     */
    public void declare(Effects declared) {
        effects = declared;
        visitColumns(new Declaring(effects, asked, room.slots()));
    }

    /** Makes the columns that bodies of more than one shape need. */
    public void holdCompounds() {
        if (shapesA == null) {
            asked.add(Need.COMPOUNDS);
            declare(effects);
            System.arraycopy(bodyA, 0, shapesA, 0, slots.high);
            System.arraycopy(bodyB, 0, shapesB, 0, slots.high);
        }
    }

    /** Makes the column that shapes need which are solid on one side alone. */
    void holdOneSided() {
        asked.add(Need.ONE_SIDED);
        declare(effects);
    }

    /** The slot of the shape of A that the pair is of. */
    public int shapeA(int pair) {
        return shapesA == null ? bodyA[pair] : shapesA[pair];
    }

    /** The slot of the shape of B that the pair is of. */
    public int shapeB(int pair) {
        return shapesB == null ? bodyB[pair] : shapesB[pair];
    }

    /** The slot of the shape of one of its bodies that the pair is of. */
    public int shapeOf(int pair, int body) {
        return bodyA[pair] == body ? shapeA(pair) : shapeB(pair);
    }

    /** How many pairs every column has room for. */
    public int room() {
        return room.slots();
    }

    /** How many some columns have room for already; more than all while the room grows. */
    int roomAhead() {
        return room.slotsAhead();
    }

    /**
     * A new pair of two shapes, that of the body with the lower slot first, linked into the lists
     * of both bodies, without contact.
     */
    public int add(Bodies bodies, int shapeA, int shapeB) {
        int pair = slots.take();
        room.hold(pair);
        bodyA[pair] = bodies.bodyOf(shapeA);
        bodyB[pair] = bodies.bodyOf(shapeB);
        if (shapesA != null) {
            shapesA[pair] = shapeA;
            shapesB[pair] = shapeB;
        }
        link(bodies, pair, 0, bodyA[pair]);
        link(bodies, pair, 1, bodyB[pair]);
        index.put(shapeA, shapeB, pair);
        clear(pair);
        mix(bodies, pair);
        return pair;
    }

    /** Makes room for so many slots. */
    public void reserve(int slotCount) {
        room.reserve(slotCount);
    }

    /** Writes what follows from the pairs and their bodies, all of which were just read. */
    public void derive(Bodies bodies) {
        for (int i = 0; i < slots.freeCount; i++) {
            bodyA[slots.free[i]] = NONE;
        }
        for (int pair : slots.occupied()) {
            reach[pair] = Double.NaN;
            // Any of them may have been active in the last step.
            list(pair);
            index.put(shapeA(pair), shapeB(pair), pair);
            mix(bodies, pair);
        }
    }

    /** Empties the list of active pairs. */
    public void beginStep() {
        activeCount = 0;
        step++;
    }

    /** Notes a pair that this step has to look at, once. */
    public void activate(int pair) {
        if (activeStep[pair] == step) {
            return;
        }
        if (activeStep[pair] != step - 1) {
            reach[pair] = Double.NaN;
        }
        activeStep[pair] = step;
        impulse[pair] = 0;
        crushed[pair] = false;
        list(pair);
    }

    /** Notes a pair within a step, before which nobody has measured it. */
    public void activateLate(int pair) {
        if (activeStep[pair] != step) {
            reach[pair] = Double.NaN;
            activate(pair);
        }
    }

    private void list(int pair) {
        if (activeCount == active.length) {
            active = Arrays.copyOf(active, 2 * activeCount);
        }
        active[activeCount++] = pair;
    }

    /** Whether this step has to look at a pair. */
    boolean isActive(int pair) {
        return activeStep[pair] == step;
    }

    /** Takes a pair out of both lists. */
    public void remove(Bodies bodies, int pair) {
        unlink(bodies, pair, 0, bodyA[pair]);
        unlink(bodies, pair, 1, bodyB[pair]);
        index.remove(shapeA(pair), shapeB(pair));
        bodyA[pair] = NONE;
        slots.giveBack(pair);
    }

    /** The next pair in the list of a body that is in this pair, or {@link #NONE}. */
    public int nextOf(int pair, int body) {
        return next[2 * pair + (bodyA[pair] == body ? 0 : 1)];
    }

    /** The other body of the pair. */
    public int other(int pair, int body) {
        return bodyA[pair] == body ? bodyB[pair] : bodyA[pair];
    }

    /**
     * The smallest gap in m over the pair's points, negative in overlap; infinite without points.
     */
    public double gap(int pair) {
        int first = 2 * pair;
        switch (points[pair]) {
            case 0:
                return Double.POSITIVE_INFINITY;
            case 1:
                return separation[first];
            default:
                return Math.min(separation[first], separation[first + 1]);
        }
    }

    /** Whether the two touched in the last step, at its end or in an impact within it. */
    public boolean touched(int pair) {
        return touching[pair] || impacts[pair] > 0;
    }

    /** Whether one of the points carried a force when the last step ended. */
    public boolean isLoaded(int pair) {
        return normalForce[2 * pair] != 0 || normalForce[2 * pair + 1] != 0;
    }

    /** The friction that held when the last step ended, N: none where no load did. */
    public double heldFriction(int pair) {
        return frictionForce != null && isLoaded(pair) ? frictionForce[pair] : 0;
    }

    /** The rolling torque that held when the last step ended, N·m: none where no load did. */
    public double heldTorque(int pair) {
        return rollingTorque != null && isLoaded(pair) ? rollingTorque[pair] : 0;
    }

    /** Mixes friction √(μaμb) and elasticity max(ea, eb) anew from the bodies' columns. */
    public void mix(Bodies bodies, int pair) {
        int a = shapeA(pair);
        int b = shapeB(pair);
        if (friction != null) {
            friction[pair] = Math.sqrt(bodies.friction[a] * bodies.friction[b]);
            frictionForce[pair] = friction[pair] > 0 ? frictionForce[pair] : 0;
        }
        if (elasticity != null) {
            elasticity[pair] = Math.max(bodies.elasticity[a], bodies.elasticity[b]);
        }
    }

    /** How fast the surfaces of both run, m/s; surface speeds are declared. */
    public double surfaceSpeed(Bodies bodies, int pair) {
        return bodies.surfaceSpeed[shapeA(pair)] + bodies.surfaceSpeed[shapeB(pair)];
    }

    /** Whether the surface of either runs; surface speeds are declared. */
    public boolean runs(Bodies bodies, int pair) {
        return bodies.surfaceSpeed[shapeA(pair)] != 0 || bodies.surfaceSpeed[shapeB(pair)] != 0;
    }

    /** The longer of the rolling levers of the two bodies, m; rolling resistance is declared. */
    public double rollingLever(Bodies bodies, int pair) {
        return Math.max(
                bodies.rollingResistance[shapeA(pair)], bodies.rollingResistance[shapeB(pair)]);
    }

    /** The mixed friction, 0 where none is declared. */
    public double frictionOf(int pair) {
        return friction == null ? 0 : friction[pair];
    }

    /** The mixed elasticity, 0 where no restitution is declared. */
    public double elasticityOf(int pair) {
        return elasticity == null ? 0 : elasticity[pair];
    }

    /** Whether the two may touch within the step in a point that nobody can tell of yet. */
    public boolean isAwaited(int pair) {
        return beside != null && points[pair] == 0 && beside[pair] >= 0;
    }

    /** Forgets all that is known of the contact. */
    public void clear(int pair) {
        normalX[pair] = 0;
        normalY[pair] = 0;
        faceOf[pair] = NONE;
        middleX[pair] = 0;
        middleY[pair] = 0;
        points[pair] = 0;
        reach[pair] = Double.NaN;
        clearPoint(2 * pair);
        clearPoint(2 * pair + 1);
        if (frictionForce != null) {
            frictionForce[pair] = 0;
        }
        if (rollingTorque != null) {
            rollingTorque[pair] = 0;
        }
        impulse[pair] = 0;
        impacts[pair] = 0;
        crushed[pair] = false;
        resting[pair] = false;
        touching[pair] = false;
        touchedBefore[pair] = false;
        activeStep[pair] = 0;
        if (passage != null) {
            passage[pair] = UNDECIDED;
            beside[pair] = NOT_AWAITED;
        }
    }

    /** Leaves it to the next step whether the two meet: a surface has become another. */
    public void reconsider(int pair) {
        if (passage != null) {
            passage[pair] = UNDECIDED;
            reach[pair] = Double.NaN;
        }
    }

    /** Takes one point away; the other becomes the first. */
    public void removePoint(int pair, int i) {
        reach[pair] = Double.NaN;
        points[pair]--;
        if (i < points[pair]) {
            movePoint(2 * pair + 1, 2 * pair);
        }
        clearPoint(2 * pair + points[pair]);
    }

    private void movePoint(int from, int to) {
        pointX[to] = pointX[from];
        pointY[to] = pointY[from];
        separation[to] = separation[from];
        feature[to] = feature[from];
        former[to] = former[from];
        normalForce[to] = normalForce[from];
        load[to] = load[from];
    }

    private void clearPoint(int point) {
        pointX[point] = 0;
        pointY[point] = 0;
        separation[point] = 0;
        feature[point] = 0;
        former[point] = NONE;
        normalForce[point] = 0;
        load[point] = 0;
    }

    private void link(Bodies bodies, int pair, int side, int body) {
        int first = bodies.firstPair[body];
        next[2 * pair + side] = first;
        previous[2 * pair + side] = NONE;
        if (first != NONE) {
            previous[2 * first + sideOf(first, body)] = pair;
        }
        bodies.firstPair[body] = pair;
    }

    private void unlink(Bodies bodies, int pair, int side, int body) {
        int before = previous[2 * pair + side];
        int after = next[2 * pair + side];
        if (before == NONE) {
            bodies.firstPair[body] = after;
        } else {
            next[2 * before + sideOf(before, body)] = after;
        }
        if (after != NONE) {
            previous[2 * after + sideOf(after, body)] = before;
        }
    }

    private int sideOf(int pair, int body) {
        return bodyA[pair] == body ? 0 : 1;
    }

    /**
     * Adds to the normal impulse that is told of a pair, N·s. A trace of pull is round-off; an
     * impact beyond all bounds puts its bodies to rest, as if it had not been.
     */
    public void tellImpulse(int pair, double pushed) {
        if (pushed > 0 && pushed < Double.POSITIVE_INFINITY) {
            impulse[pair] += pushed;
        }
    }
}
