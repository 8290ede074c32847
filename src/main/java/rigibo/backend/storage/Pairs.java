package rigibo.backend.storage;

import rigibo.backend.effect.Effects;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;

/**
 * Columns of the candidate pairs: two shapes whose fixtures overlap, with the state of the contact
 * between them. Body A is the one with the lower slot. A pair is in the lists of both its bodies;
 * columns of two values per pair are indexed {@code 2 * pair + point}. {@link PairColumns} lists
 * all columns, for operations on every one of them.
 */
public final class Pairs {

    /** Marks the end of a list. */
    public static final int NONE = -1;

    /**
     * Values of {@link #passage}: not decided yet; the two collide; one is behind the surface of
     * the other, so they do not; one is just coming through that surface.
     */
    public static final int UNDECIDED = 0;

    public static final int MEETS = 1;
    public static final int PASSES = 2;
    public static final int COMES_THROUGH = 3;

    /** Value of {@link #beside}: without a point, the two cannot touch in this step. */
    public static final double NOT_AWAITED = -1;

    private static final int FIRST_CAPACITY = 64;

    public final Slots slots = new Slots();
    public final PairIndex index = new PairIndex();

    /** Slots of the two bodies; {@link #NONE} in A marks an empty slot. */
    public int[] bodyA = new int[FIRST_CAPACITY];

    public int[] bodyB = new int[FIRST_CAPACITY];

    /**
     * Slots of the two shapes if some body has several; otherwise null, and the slots are the
     * bodies' own.
     */
    int[] shapesA;

    int[] shapesB;

    /** Links of the two lists that hold the pair: 2·pair in A's, 2·pair + 1 in B's. */
    public int[] next = new int[2 * FIRST_CAPACITY];

    public int[] previous = new int[2 * FIRST_CAPACITY];

    /** Unit normal from A to B. Number of contact points: 0, 1 or 2, in {@link #points}. */
    public double[] normalX = new double[FIRST_CAPACITY];

    public double[] normalY = new double[FIRST_CAPACITY];

    /**
     * Slot of the body with the reference face, or {@link #NONE} where the normal joins two points.
     */
    public int[] faceOf = new int[FIRST_CAPACITY];

    public int[] points = new int[FIRST_CAPACITY];

    /**
     * Distance (m) up to which the last step searched for points at its start; NaN if none did, or
     * if the points were changed since.
     */
    public double[] reach = new double[FIRST_CAPACITY];

    /** By point: world position in m, separation in m (negative in overlap), and feature id. */
    public double[] pointX = new double[2 * FIRST_CAPACITY];

    public double[] pointY = new double[2 * FIRST_CAPACITY];
    public double[] separation = new double[2 * FIRST_CAPACITY];
    public int[] feature = new int[2 * FIRST_CAPACITY];

    /**
     * Reference position of the bodies when the points were measured, m: the centre of the one that
     * is not dynamic, or else the middle between both centres.
     */
    public double[] middleX = new double[FIRST_CAPACITY];

    public double[] middleY = new double[FIRST_CAPACITY];

    /** By point: the point of the previous manifold that it continues, 0 or 1, or {@link #NONE}. */
    public int[] former = new int[2 * FIRST_CAPACITY];

    /** By point: normal force at the end of the last step, N, for warm starting. */
    public double[] normalForce = new double[2 * FIRST_CAPACITY];

    /** By point: normal force averaged over the last seconds, N. */
    public double[] load = new double[2 * FIRST_CAPACITY];

    /**
     * Null unless the effect is declared: coefficients mixed from both materials; friction force
     * (N) and rolling torque (N·m) at the end of the last step, without meaning where no point
     * carries a force.
     */
    public double[] friction;

    public double[] elasticity;
    public double[] frictionForce;
    public double[] rollingTorque;

    /** Normal impulse of the last step, including impacts, N·s. */
    public double[] impulse = new double[FIRST_CAPACITY];

    /** Number of impacts of the pair in this step. */
    public int[] impacts = new int[FIRST_CAPACITY];

    /** Whether a driven body overlaps the other one so deeply that it presses no further. */
    public boolean[] crushed = new boolean[FIRST_CAPACITY];

    /** Whether the pair presses without bouncing and so belongs to a pile. */
    public boolean[] resting = new boolean[FIRST_CAPACITY];

    /** Whether the pair touched in this step, and in the one before. */
    public boolean[] touching = new boolean[FIRST_CAPACITY];

    public boolean[] touchedBefore = new boolean[FIRST_CAPACITY];

    /**
     * For pairs with a shape that is solid on one side only: whether the two collide; null where
     * there is no such shape.
     */
    public int[] passage;

    /**
     * For pairs without points that include an edge of a chain: gap (m) to a body that may come
     * over the end of the edge within the searched distance, else {@link #NOT_AWAITED}. Null
     * together with {@link #passage}.
     */
    public double[] beside;

    /** The pairs that this step visits, since one of their bodies moves. */
    public int[] active = new int[FIRST_CAPACITY];

    public int activeCount;

    /** Step in which a pair was last listed as active, and the number of this step. */
    int[] activeStep = new int[FIRST_CAPACITY];

    private int step;

    private Effects effects;

    private final Set<Need> asked = EnumSet.noneOf(Need.class);

    private final Room room = new Room(FIRST_CAPACITY, this::visitColumns);

    /** Creates the columns that a set of effects needs. */
    public Pairs(Effects effects) {
        declare(effects);
    }

    /** Passes every column to a visitor, which may replace the arrays. */
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

    /** Makes the columns for bodies with more than one shape. */
    public void holdCompounds() {
        if (shapesA == null) {
            asked.add(Need.COMPOUNDS);
            declare(effects);
            System.arraycopy(bodyA, 0, shapesA, 0, slots.high);
            System.arraycopy(bodyB, 0, shapesB, 0, slots.high);
        }
    }

    /** Makes the columns for shapes that are solid on one side only. */
    void holdOneSided() {
        asked.add(Need.ONE_SIDED);
        declare(effects);
    }

    /** The slot of A's shape in the pair. */
    public int shapeA(int pair) {
        return shapesA == null ? bodyA[pair] : shapesA[pair];
    }

    /** The slot of B's shape in the pair. */
    public int shapeB(int pair) {
        return shapesB == null ? bodyB[pair] : shapesB[pair];
    }

    /** The slot of the shape that a body has in the pair. */
    public int shapeOf(int pair, int body) {
        return bodyA[pair] == body ? shapeA(pair) : shapeB(pair);
    }

    /** Number of pairs for which every column has room. */
    public int room() {
        return room.slots();
    }

    /**
     * Number of pairs for which some columns have room; more than {@link #room} while the columns
     * grow.
     */
    int roomAhead() {
        return room.slotsAhead();
    }

    /**
     * Adds a pair of two shapes, without contact, to the lists of both bodies; the shape of the
     * body with the lower slot comes first. Returns its slot.
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

    /** Makes room for a number of slots. */
    public void reserve(int slotCount) {
        room.reserve(slotCount);
    }

    /** Computes the derived columns after pairs and bodies were read from a snapshot. */
    public void derive(Bodies bodies) {
        for (int i = 0; i < slots.freeCount; i++) {
            bodyA[slots.free[i]] = NONE;
        }
        for (int pair : slots.occupied()) {
            reach[pair] = Double.NaN;
            // Each of them may have been active in the last step.
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

    /** Lists a pair as active, once. */
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

    /** Lists a pair as active within a step; it has not been measured yet. */
    public void activateLate(int pair) {
        if (activeStep[pair] != step) {
            reach[pair] = Double.NaN;
            activate(pair);
        }
    }

    private void list(int pair) {
        if (activeCount == active.length) {
            active = Arrays.copyOf(active, Growth.after(activeCount));
        }
        active[activeCount++] = pair;
    }

    /** Whether this step visits a pair. */
    boolean isActive(int pair) {
        return activeStep[pair] == step;
    }

    /** Removes a pair from both lists and frees its slot. */
    public void remove(Bodies bodies, int pair) {
        unlink(bodies, pair, 0, bodyA[pair]);
        unlink(bodies, pair, 1, bodyB[pair]);
        index.remove(shapeA(pair), shapeB(pair));
        bodyA[pair] = NONE;
        slots.giveBack(pair);
    }

    /** The next pair in a body's list after this one, or {@link #NONE}. */
    public int nextOf(int pair, int body) {
        return next[2 * pair + (bodyA[pair] == body ? 0 : 1)];
    }

    /** The other body of the pair. */
    public int other(int pair, int body) {
        return bodyA[pair] == body ? bodyB[pair] : bodyA[pair];
    }

    /**
     * The smallest separation in m over the pair's points, negative in overlap; infinite without
     * points.
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

    /** Whether the two touched in the last step, at its end or in an impact during it. */
    public boolean touched(int pair) {
        return touching[pair] || impacts[pair] > 0;
    }

    /** Whether one of the points carried a force at the end of the last step. */
    public boolean isLoaded(int pair) {
        return normalForce[2 * pair] != 0 || normalForce[2 * pair + 1] != 0;
    }

    /** The friction force at the end of the last step, N; 0 if no point carried a force. */
    public double heldFriction(int pair) {
        return frictionForce != null && isLoaded(pair) ? frictionForce[pair] : 0;
    }

    /** The rolling torque at the end of the last step, N·m; 0 if no point carried a force. */
    public double heldTorque(int pair) {
        return rollingTorque != null && isLoaded(pair) ? rollingTorque[pair] : 0;
    }

    /** Mixes friction √(μaμb) and elasticity max(ea, eb) from the columns of both bodies. */
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

    /** Sum of the surface speeds of both bodies, m/s; needs declared surface speeds. */
    public double surfaceSpeed(Bodies bodies, int pair) {
        return bodies.surfaceSpeed[shapeA(pair)] + bodies.surfaceSpeed[shapeB(pair)];
    }

    /** Whether the surface of either body runs; needs declared surface speeds. */
    public boolean runs(Bodies bodies, int pair) {
        return bodies.surfaceSpeed[shapeA(pair)] != 0 || bodies.surfaceSpeed[shapeB(pair)] != 0;
    }

    /**
     * The longer one of the rolling levers of the two bodies, m; needs declared rolling resistance.
     */
    public double rollingLever(Bodies bodies, int pair) {
        return Math.max(
                bodies.rollingResistance[shapeA(pair)], bodies.rollingResistance[shapeB(pair)]);
    }

    /** The mixed coefficient of friction; 0 where none is declared. */
    public double frictionOf(int pair) {
        return friction == null ? 0 : friction[pair];
    }

    /** The mixed elasticity; 0 where no restitution is declared. */
    public double elasticityOf(int pair) {
        return elasticity == null ? 0 : elasticity[pair];
    }

    /** Whether the two have no point yet but may touch within the step at one that is not known. */
    public boolean isAwaited(int pair) {
        return beside != null && points[pair] == 0 && beside[pair] >= 0;
    }

    /** Resets the contact to one without points. */
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

    /**
     * Leaves it to the next step to decide whether the two collide, because a surface was changed.
     */
    public void reconsider(int pair) {
        if (passage != null) {
            passage[pair] = UNDECIDED;
            reach[pair] = Double.NaN;
        }
    }

    /** Removes one point; the other one becomes the first. */
    public void removePoint(int pair, int i) {
        reach[pair] = Double.NaN;
        points[pair]--;
        if (i < points[pair]) {
            movePoint(2 * pair + 1, 2 * pair);
        }
        clearPoint(2 * pair + points[pair]);
    }

    /** Removes all points. */
    public void removePoints(int pair) {
        while (points[pair] > 0) {
            removePoint(pair, points[pair] - 1);
        }
    }

    /** Appends a point of another pair, which loses it, to the points of a pair. */
    public void takePoint(int pair, int other, int i) {
        movePoint(2 * other + i, 2 * pair + points[pair]);
        points[pair]++;
        reach[pair] = Double.NaN;
        removePoint(other, i);
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
     * Adds to the reported normal impulse of a pair, N·s. A negative amount is round-off. One that
     * is not finite belongs to an impact that puts its bodies to rest, as if it had not happened.
     */
    public void tellImpulse(int pair, double pushed) {
        if (pushed > 0 && pushed < Double.POSITIVE_INFINITY) {
            impulse[pair] += pushed;
        }
    }
}
