package rigibo.backend.contact.hold;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.KeptOverlap;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Tests whether an island rests on the forces that its contacts carried when the last step ended:
 * whether they balance all present accelerations of every body, Σ F + m·a = 0 and Σ r × F + I·α =
 * 0, each force within its bounds. Then nothing moves, and solving would find the same forces
 * again. The test needs no memory of changes, since every change shows in the sums.
 */
public final class Equilibrium {

    /** Largest imbalance of a body, as a share of its own loads. */
    public static final double UNHELD = 1e-9;

    /**
     * Factor on the allowed imbalance and motion of a body in a crowd: the compliance of rows adds
     * up from storey to storey, and passes leave an error.
     */
    private static final double IN_A_CROWD = 10;

    /**
     * Largest imbalance of a joined body, as a share of its own loads. Joints are solved to
     * round-off, which adds up to this share at the ends of a chain.
     */
    private static final double UNHELD_BY_JOINTS = 1e-10;

    /**
     * Share by which friction and rolling may exceed their bounds. Rounds bound them by the load of
     * the round before, and end once the load changes by less than this.
     */
    public static final double BEYOND_CONE = 1e-7;

    /**
     * Distance that a joined body may move in a step, in widths, since the compliance of rows adds
     * up in a long chain; faster bodies need a closer test.
     */
    private static final double SLOW = 1e-6;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;

    /** Allowed excess of the overlap that is left, in units in the last place of positions. */
    private static final double LOST = 4;

    /** Whether overlap is corrected, which moves bodies. */
    private final boolean isCorrecting;

    private final Accuracy accuracy;

    /**
     * Kept overlap in the tested island, in widths, and on top of it an overlap so small that
     * {@link Stillness} counts bodies which part by its removal as still.
     */
    private double kept;

    /** Whether bodies of the tested island overlap by more. */
    private boolean isOverlapping;

    /** By slot: acceleration that contacts leave unbalanced, m/s² and rad/s². */
    private double[] leftX = new double[16];

    private double[] leftY = new double[16];
    private double[] leftTurn = new double[16];

    /** By slot: sum of the magnitudes of its pull and of its contacts' forces per mass, m/s². */
    private double[] own = new double[16];

    /** A test of the islands of a storage, at an accuracy. */
    public Equilibrium(DataStorage data, Accuracy accuracy) {
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        isCorrecting = accuracy.correction() == Correction.SOFT;
        this.accuracy = accuracy;
    }

    /**
     * Whether the carried forces hold an island in place for a step of {@code dt} seconds, apart
     * from removal of overlap.
     */
    boolean lasts(int island, double dt) {
        double times = PackedContacts.areCrowd(islands, island) ? IN_A_CROWD : 1;
        return mayLast(island, dt, times * Stillness.STILL)
                && isEveryBodyHeld(island, times * UNHELD);
    }

    /**
     * Whether the bodies and contacts of an island with joints allow it to rest. If so, pulls and
     * contact forces have been summed, and the forces of joints are to be added.
     */
    public boolean mayLast(int island, double dt) {
        return mayLast(island, dt, SLOW) && !isOverlapping;
    }

    /** Whether the last tested island has overlap to be removed. */
    boolean isOverlapping() {
        return isOverlapping;
    }

    private boolean mayLast(int island, double dt, double share) {
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            if (bodies.pileTime[slot] != 0
                    || !(speed(slot) * dt <= share * bodies.smallestWidth[slot])) {
                return false;
            }
        }
        return areContactsSteady(island, dt);
    }

    /**
     * Whether the sums leave every body of an island with joints in place for a step of {@code dt}
     * seconds with kicks of {@code kicked} seconds. The compliance of rows adds up along a chain,
     * so its end may move as fast as the strongest load allows.
     */
    public boolean isHeld(int island, double dt, double kicked) {
        double strongest = 0;
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            strongest = Math.max(strongest, own[islands.bodies[i]]);
        }
        double gives = Stillness.UNHELD * kicked * strongest;
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            double still = Stillness.STILL * bodies.smallestWidth[slot] / dt;
            if (!(speed(slot) <= Math.max(still, gives))) {
                return false;
            }
        }
        boolean areTouching = islands.pairStart[island + 1] > islands.pairStart[island];
        return isEveryBodyHeld(island, areTouching ? UNHELD : UNHELD_BY_JOINTS);
    }

    /** Highest speed of any point of a body, m/s. */
    private double speed(int slot) {
        double speed = Math.abs(bodies.velocityX[slot]) + Math.abs(bodies.velocityY[slot]);
        return speed + bodies.boundingRadius[slot] * Math.abs(bodies.spinOf(slot));
    }

    private double pull(int slot) {
        return Math.abs(bodies.accelerationX[slot]) + Math.abs(bodies.accelerationY[slot]);
    }

    private boolean areContactsSteady(int island, double dt) {
        reserve();
        isOverlapping = false;
        kept = KeptOverlap.ifCalm(PackedContacts.areCrowd(islands, island), accuracy);
        kept += Recovery.overlapOf(Stillness.STILL, dt);
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            leftX[slot] = bodies.accelerationX[slot];
            leftY[slot] = bodies.accelerationY[slot];
            leftTurn[slot] = bodies.turns() ? bodies.angularAcceleration[slot] : 0;
            own[slot] = pull(slot);
        }
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int pair = islands.pairs[i];
            if (!isSteady(pair)) {
                return false;
            }
            addForces(pair);
        }
        return true;
    }

    /** Adds another force (N) and torque about the centre of mass (N·m) to a body's sums. */
    public void add(int slot, double x, double y, double torque) {
        leftX[slot] += bodies.inverseMass[slot] * x;
        leftY[slot] += bodies.inverseMass[slot] * y;
        own[slot] += bodies.inverseMass[slot] * (Math.abs(x) + Math.abs(y));
        if (bodies.turns()) {
            double turned = bodies.inverseInertia[slot] * torque;
            leftTurn[slot] += turned;
            own[slot] += bodies.boundingRadius[slot] * Math.abs(turned);
        }
    }

    /** Whether each body is balanced to within a share of its own loads. */
    private boolean isEveryBodyHeld(int island, double unheld) {
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            double left = Math.abs(leftX[slot]) + Math.abs(leftY[slot]);
            left += bodies.boundingRadius[slot] * Math.abs(leftTurn[slot]);
            if (!(left <= unheld * own[slot])) {
                return false;
            }
        }
        return true;
    }

    private void reserve() {
        if (leftX.length < bodies.type.length) {
            leftX = new double[bodies.type.length];
            leftY = new double[bodies.type.length];
            leftTurn = new double[bodies.type.length];
            own = new double[bodies.type.length];
        }
    }

    /** Whether a contact can keep its forces: it is closed, and they are within their bounds. */
    private boolean isSteady(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double width = PairTolerances.width(bodies, a, b);
        double most = kept * width + resolution(a) + resolution(b);
        if (bodies.isDriven(a) || bodies.isDriven(b)) {
            return false;
        }
        isOverlapping |= isCorrecting && pairs.gap(pair) < -most;
        if (bodies.surfaceSpeed != null && pairs.runs(bodies, pair)) {
            return false;
        }
        double touching = PairTolerances.TOUCHING_GAP * width;
        double load0 = pairs.normalForce[2 * pair];
        double load1 = pairs.normalForce[2 * pair + 1];
        return (load0 == 0 || pairs.separation[2 * pair] <= touching)
                && (load1 == 0 || pairs.separation[2 * pair + 1] <= touching);
    }

    /**
     * Distance that round-off of positions hides, m: a smaller removal of overlap has no effect.
     */
    private double resolution(int slot) {
        double far = Math.max(Math.abs(bodies.x[slot]), Math.abs(bodies.y[slot]));
        return LOST * (Math.nextUp(far) - far);
    }

    /**
     * The carried friction, N, limited to its bound at a load. The part beyond the bound is then
     * missing in the sums and shows as an imbalance.
     */
    private double rubs(int pair, double load) {
        return within(pairs.heldFriction(pair), pairs.frictionOf(pair) * load);
    }

    /** The carried rolling torque, N·m, limited to its bound at a load. */
    private double rolls(int pair, double load) {
        double torque = pairs.heldTorque(pair);
        return torque == 0 ? 0 : within(torque, pairs.rollingLever(bodies, pair) * load);
    }

    private static double within(double held, double bound) {
        double most = (1 + BEYOND_CONE) * bound;
        return Math.max(-most, Math.min(most, held));
    }

    private void addForces(int pair) {
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        double load = pairs.normalForce[2 * pair] + pairs.normalForce[2 * pair + 1];
        double along = rubs(pair, load);
        double fx = load * nx - along * ny;
        double fy = load * ny + along * nx;
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double carried = load + Math.abs(along);
        own[a] += bodies.inverseMass[a] * carried;
        own[b] += bodies.inverseMass[b] * carried;
        leftX[a] -= bodies.inverseMass[a] * fx;
        leftY[a] -= bodies.inverseMass[a] * fy;
        leftX[b] += bodies.inverseMass[b] * fx;
        leftY[b] += bodies.inverseMass[b] * fy;
        if (bodies.turns() && load > 0) {
            double rubsAt = RowBuilder.rubsAt(pairs, pair, nx, ny);
            double rolling = rolls(pair, load);
            leftTurn[a] -= bodies.inverseInertia[a] * (rolling + torque(pair, a, along, rubsAt));
            leftTurn[b] += bodies.inverseInertia[b] * (rolling + torque(pair, b, along, rubsAt));
        }
    }

    /**
     * Torque of a contact about a body's centre of mass, N·m, as on B, with friction at its height.
     */
    private double torque(int pair, int slot, double along, double rubsAt) {
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        double x = bodies.x[slot];
        double y = bodies.y[slot];
        double sum = 0;
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            double lever = (pairs.pointX[point] - x) * ny - (pairs.pointY[point] - y) * nx;
            sum += lever * pairs.normalForce[point];
        }
        return sum + along * (rubsAt - x * nx - y * ny);
    }
}
