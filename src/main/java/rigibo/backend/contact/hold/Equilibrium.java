package rigibo.backend.contact.hold;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Tells whether an island rests by what it carries already: whether the forces that held when the
 * last step ended hold every body against what pulls at it now, Σ F + m·a = 0 and Σ r × F + I·α =
 * 0, each of them within its bounds. Then nothing moves, and solving would find the same forces
 * again. Nothing is remembered for it: whatever changed since shows in the sums.
 */
public final class Equilibrium {

    /** Share of its own loads by which a body may be held too little or too much. */
    public static final double UNHELD = 1e-9;

    /**
     * How many times more a body of a crowd may be held too little, and move: what rows give way by
     * adds up from storey to storey, and passes leave a share of it.
     */
    private static final double IN_A_CROWD = 10;

    /**
     * Share of its own loads by which a joined body may be held too little or too much. Joints are
     * solved to round-off, and what a chain carries at its ends is off by as much as this.
     */
    private static final double UNHELD_BY_JOINTS = 1e-10;

    /**
     * Share by which friction and rolling may exceed their bounds: rounds bound them by the load of
     * the round before, and end where a load changes by less.
     */
    public static final double BEYOND_CONE = 1e-7;

    /**
     * Share of its width by which a joined body may move in a step before more is looked at: what
     * rows of a long chain give way by adds up.
     */
    private static final double SLOW = 1e-6;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Islands islands;

    /** Distances of neighbouring doubles by which what is left of an overlap may exceed that. */
    private static final double LOST = 4;

    /** Whether overlap is taken back, which moves bodies. */
    private final boolean isCorrecting;

    private final Accuracy accuracy;

    /**
     * Overlap that stays in the island that is asked for, in widths, with what is so little beyond
     * it that {@link Stillness} takes the island for one at rest.
     */
    private double kept;

    /** Whether anything in that island overlaps by more. */
    private boolean isOverlapping;

    /** By slot: what is left of its acceleration, m/s² and rad/s². */
    private double[] leftX = new double[16];

    private double[] leftY = new double[16];
    private double[] leftTurn = new double[16];

    /** By slot: what pulls at it and what its contacts carry, all by amount, m/s². */
    private double[] own = new double[16];

    /** Of what is stored, at an accuracy. */
    public Equilibrium(DataStorage data, Accuracy accuracy) {
        bodies = data.bodies;
        pairs = data.pairs;
        islands = data.islands;
        isCorrecting = accuracy.correction() == Correction.SOFT;
        this.accuracy = accuracy;
    }

    /**
     * Whether forces hold an island as it is for a step of {@code dt} seconds; overlap may be taken
     * back, though.
     */
    boolean lasts(int island, double dt) {
        double times = PackedContacts.areCrowd(islands, island) ? IN_A_CROWD : 1;
        return mayLast(island, dt, times * Stillness.STILL)
                && isEveryBodyHeld(island, times * UNHELD);
    }

    /**
     * Whether an island with joints may rest, as far as its bodies and contacts tell. Then what
     * pulls at the bodies is summed up with what contacts carry, for joints to be added.
     */
    public boolean mayLast(int island, double dt) {
        return mayLast(island, dt, SLOW) && !isOverlapping;
    }

    /** Whether there is overlap to take back in the island that was asked for last. */
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
     * Whether all that was summed up leaves every body of an island with joints where it is for a
     * step of {@code dt} seconds, whose kicks are {@code kicked} seconds long. What rows give way
     * by adds up along a chain, so that its end goes as fast as the strongest load allows.
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

    /** The fastest that any point of a body goes, m/s. */
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
        kept = Recovery.keptIfCalm(PackedContacts.areCrowd(islands, island), accuracy);
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

    /** Adds what else holds a body: a force in N, and a torque about its centre of mass in N·m. */
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

    /** Whether each body is held but for a share of its own loads. */
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

    /** Whether a contact goes on carrying what it carries: closed, and within its bounds. */
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

    /** What is taken back of an overlap in a step is lost where places lie farther apart, m. */
    private double resolution(int slot) {
        return LOST * Math.ulp(Math.max(Math.abs(bodies.x[slot]), Math.abs(bodies.y[slot])));
    }

    /**
     * The friction that held, N, as far as its bounds go by a load. What was beyond them is missing
     * in the sums, so that it counts by what it held.
     */
    private double rubs(int pair, double load) {
        return within(pairs.heldFriction(pair), pairs.frictionOf(pair) * load);
    }

    /** The rolling torque that held, N·m, likewise. */
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

    /** Σ r × F about a body's centre, N·m, as B feels it, with the friction and its height. */
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
