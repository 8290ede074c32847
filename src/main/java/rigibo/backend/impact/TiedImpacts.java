package rigibo.backend.impact;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * Impacts that fall on the same instant and share bodies, resolved at once: one after the other
 * they would give the first of two equals more than the second.
 *
 * <p>Every point asks for vₙ' ≥ −e·vₙ, j ≥ 0, and one of the two as an equation; every pair for
 * |jₜ| ≤ μ·Σjₙ. Passes over the rows go on until nothing changes (projected Gauss–Seidel, which
 * converges for such problems; R. W. Cottle et al., The Linear Complementarity Problem, 1992, ch.
 * 5). For e = 1 and μ = 0 the limit keeps the energy, as one impact does; where friction would add
 * to it, all impulses are scaled back.
 */
public final class TiedImpacts {

    /** Passes after which impacts count as ones without an answer. */
    public static final int MOST_PASSES = 300;

    /** A change of speed that is round-off, as a share of the fastest approach. */
    private static final double ROUND_OFF = 1e-15;

    /** How many times faster than the fastest row impacts without an answer may leave one. */
    private static final double MOST_LEVERAGE = 2;

    /** Doubles per row, and where each quantity sits. */
    private static final int STRIDE = 9;

    private static final int DX = 0;
    private static final int DY = 1;
    private static final int LEVER_A = 2;
    private static final int LEVER_B = 3;
    private static final int RESPONSE = 4;
    private static final int TARGET = 5;
    private static final int IMPULSE = 6;
    private static final int FRICTION = 7;
    private static final int SPEED_BEFORE = 8;

    private final Bodies bodies;
    private final Pairs pairs;
    private double[] row = new double[16 * STRIDE];
    private int[] pairOf = new int[16];

    /** For a tangent row its number of normal rows, which stand before it; 0 for a normal row. */
    private int[] points = new int[16];

    private int count;
    private double fastest;
    private int passes;

    /** How many solutions have changed something so far. */
    private int changes;

    /** By slot the last of them that moved the body, and by row the last that it has answered. */
    private int[] movedBy = new int[16];

    private int[] answered = new int[16];

    private static final int NONE = -1;

    /** Impacts between bodies of these columns. */
    public TiedImpacts(Bodies bodies, Pairs pairs) {
        this.bodies = bodies;
        this.pairs = pairs;
    }

    /** Begins another instant. */
    public void clear() {
        count = 0;
        fastest = 0;
        changes = 0;
    }

    /** Adds the impact of a pair, with the elasticity it is to have; nothing moves yet. */
    public void add(int pair, Impact impact, double elasticity) {
        for (int i = 0; i < impact.points; i++) {
            double speed = impact.parting(i);
            fastest = Math.max(fastest, -speed);
            add(pair, impact.normalX, impact.normalY, impact, i, i);
            row[(count - 1) * STRIDE + TARGET] = speed < 0 ? -elasticity * speed : 0;
        }
        if (impact.friction > 0 && impact.points > 0) {
            add(pair, -impact.normalY, impact.normalX, impact, 0, impact.points - 1);
            row[(count - 1) * STRIDE + FRICTION] = impact.friction;
            row[(count - 1) * STRIDE + TARGET] = impact.surfaceSpeed;
            points[count - 1] = impact.points;
        }
    }

    /** A row through the middle of two of the impact's points. */
    private void add(int pair, double x, double y, Impact impact, int i, int j) {
        if (count == pairOf.length) {
            row = Arrays.copyOf(row, 2 * count * STRIDE);
            pairOf = Arrays.copyOf(pairOf, 2 * count);
            points = Arrays.copyOf(points, 2 * count);
            answered = Arrays.copyOf(answered, 2 * count);
        }
        double leverA =
                ((impact.armAX[i] + impact.armAX[j]) * y - (impact.armAY[i] + impact.armAY[j]) * x)
                        / 2;
        double leverB =
                ((impact.armBX[i] + impact.armBX[j]) * y - (impact.armBY[i] + impact.armBY[j]) * x)
                        / 2;
        int at = count * STRIDE;
        Arrays.fill(row, at, at + STRIDE, 0);
        row[at + DX] = x;
        row[at + DY] = y;
        row[at + LEVER_A] = leverA;
        row[at + LEVER_B] = leverB;
        row[at + RESPONSE] =
                impact.inverseMassA
                        + impact.inverseMassB
                        + impact.inverseInertiaA * leverA * leverA
                        + impact.inverseInertiaB * leverB * leverB;
        if (movedBy.length < bodies.type.length) {
            movedBy = Arrays.copyOf(movedBy, bodies.type.length);
        }
        pairOf[count] = pair;
        movedBy[pairs.bodyA[pair]] = 0;
        movedBy[pairs.bodyB[pair]] = 0;
        answered[count] = NONE;
        points[count++] = 0;
        row[at + SPEED_BEFORE] = speed(count - 1);
    }

    /** How many rows a pass goes over. */
    public int rows() {
        return count;
    }

    /** How many passes the last impacts took after the first. */
    public int passes() {
        return passes;
    }

    /**
     * Changes the velocities of all bodies, and adds up the impulses of the pairs. Returns whether
     * the impacts have an answer: between a driven body and a wall nothing can part from both.
     */
    public boolean resolve() {
        boolean isAnswered = solve(MOST_PASSES);
        keep(isAnswered);
        return isAnswered;
    }

    /** Changes velocities alone. Returns whether so many passes came to an answer. */
    public boolean solve(int mostPasses) {
        double settled = ROUND_OFF * fastest;
        passes = 0;
        while (pass() > settled && passes < mostPasses) {
            passes++;
        }
        return passes < mostPasses;
    }

    /** Adds up the impulses of the pairs, once they add no energy; or no speed, if unanswered. */
    public void keep(boolean isAnswered) {
        limitEnergy();
        if (!isAnswered) {
            limitSpeed();
        }
        for (int i = 0; i < count; i++) {
            if (points[i] == 0) {
                pairs.tellImpulse(pairOf[i], row[i * STRIDE + IMPULSE]);
            }
        }
    }

    /** The work of impulses scaled by s is s·j·v + ½s²·j·Δv; it must not be positive. */
    private void limitEnergy() {
        double linear = 0;
        double quadratic = 0;
        for (int i = 0; i < count; i++) {
            int at = i * STRIDE;
            // What a running surface does to what it carries is work of its drive.
            double driven = points[i] > 0 ? row[at + TARGET] : 0;
            linear += row[at + IMPULSE] * (row[at + SPEED_BEFORE] - driven);
            quadratic += row[at + IMPULSE] * (speed(i) - row[at + SPEED_BEFORE]) / 2;
        }
        if (linear + quadratic > 0) {
            scale(Math.max(0, -linear / quadratic));
        }
    }

    /** Scales all impulses back until no row is much faster than the fastest one was. */
    private void limitSpeed() {
        double most = 0;
        for (int i = 0; i < count; i++) {
            most = Math.max(most, Math.abs(row[i * STRIDE + SPEED_BEFORE]));
        }
        double limit = MOST_LEVERAGE * most;
        double share = 1;
        for (int i = 0; i < count; i++) {
            double before = row[i * STRIDE + SPEED_BEFORE];
            double change = speed(i) - before;
            if (Math.abs(before + share * change) > limit) {
                share = (limit - Math.abs(before)) / Math.abs(change);
            }
        }
        scale(share);
    }

    private void scale(double share) {
        for (int i = 0; i < count; i++) {
            push(i, (share - 1) * row[i * STRIDE + IMPULSE]);
            row[i * STRIDE + IMPULSE] *= share;
        }
    }

    /**
     * One pass over all rows whose bodies have moved since they were solved last: an impact far
     * from them is none of their matter. Returns the largest change of speed, m/s.
     */
    private double pass() {
        double most = 0;
        for (int i = 0; i < count; i++) {
            int a = pairs.bodyA[pairOf[i]];
            int b = pairs.bodyB[pairOf[i]];
            if (Math.max(movedBy[a], movedBy[b]) > answered[i]) {
                most = Math.max(most, solveRow(i, a, b));
            }
        }
        return most;
    }

    private double solveRow(int i, int a, int b) {
        int at = i * STRIDE;
        double old = row[at + IMPULSE];
        double wanted = old + (row[at + TARGET] - speed(i)) / row[at + RESPONSE];
        double limited = points[i] == 0 ? Math.max(0, wanted) : withinCone(i, wanted);
        if (limited != old) {
            row[at + IMPULSE] = limited;
            push(i, limited - old);
            changes++;
            movedBy[a] = bodies.isDynamic(a) ? changes : 0;
            movedBy[b] = bodies.isDynamic(b) ? changes : 0;
        }
        answered[i] = changes;
        return Math.abs(limited - old) * row[at + RESPONSE];
    }

    private double withinCone(int tangent, double wanted) {
        double normal = 0;
        for (int i = tangent - points[tangent]; i < tangent; i++) {
            normal += row[i * STRIDE + IMPULSE];
        }
        double most = row[tangent * STRIDE + FRICTION] * normal;
        return Math.max(-most, Math.min(most, wanted));
    }

    /** How fast B moves against A along a row, m/s. */
    private double speed(int i) {
        int at = i * STRIDE;
        int a = pairs.bodyA[pairOf[i]];
        int b = pairs.bodyB[pairOf[i]];
        return row[at + DX] * (bodies.velocityX[b] - bodies.velocityX[a])
                + row[at + DY] * (bodies.velocityY[b] - bodies.velocityY[a])
                + row[at + LEVER_B] * bodies.spinOf(b)
                - row[at + LEVER_A] * bodies.spinOf(a);
    }

    private void push(int i, double impulse) {
        int at = i * STRIDE;
        double x = row[at + DX] * impulse;
        double y = row[at + DY] * impulse;
        push(pairs.bodyA[pairOf[i]], -x, -y, -row[at + LEVER_A] * impulse);
        push(pairs.bodyB[pairOf[i]], x, y, row[at + LEVER_B] * impulse);
    }

    private void push(int slot, double x, double y, double turn) {
        // An impulse beyond all bounds would move even what has no inverse mass: 0·∞.
        if (!bodies.isDynamic(slot)) {
            return;
        }
        bodies.velocityX[slot] += bodies.inverseMass[slot] * x;
        bodies.velocityY[slot] += bodies.inverseMass[slot] * y;
        if (bodies.turns()) {
            bodies.spin[slot] += bodies.inverseInertia[slot] * turn;
        }
    }
}
