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
    private static final int MOST_PASSES = 300;

    /** A change of speed that is round-off, as a share of the fastest approach. */
    private static final double ROUND_OFF = 1e-14;

    /** How many times faster than the fastest row impacts without an answer may leave one. */
    private static final double MOST_LEVERAGE = 2;

    /** Passes between two eliminations: they find anew which rows carry something. */
    private static final int PASSES_EACH = 4;

    /** What is left must have shrunk to this share since the last elimination; else it cycles. */
    private static final double SHRINKS = 0.5;

    /** What solving a row takes, in multiplications of an elimination. */
    static final int WORK_OF_ROW = 60;

    private final Bodies bodies;
    private final Pairs pairs;
    private final TiedRows rows;
    private final TiedElimination elimination;

    private double fastest;
    private double work;

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
        rows = new TiedRows(bodies, pairs);
        elimination = new TiedElimination(rows);
    }

    /** Begins another instant. */
    public void clear() {
        rows.count = 0;
        fastest = 0;
        changes = 0;
    }

    /** Adds the impact of a pair, with the elasticity it is to have; nothing moves yet. */
    public void add(int pair, Impact impact, double elasticity) {
        for (int i = 0; i < impact.points; i++) {
            double speed = impact.parting(i);
            fastest = Math.max(fastest, -speed);
            int row = add(pair, impact.normalX, impact.normalY, impact, i, i);
            rows.target[row] = speed < 0 ? -elasticity * speed : 0;
        }
        if (impact.friction > 0 && impact.points > 0) {
            int last = impact.points - 1;
            int row = add(pair, -impact.normalY, impact.normalX, impact, 0, last);
            rows.makeTangent(row, impact.points, impact.friction);
            rows.target[row] = impact.surfaceSpeed;
        }
    }

    private int add(int pair, double x, double y, Impact impact, int i, int j) {
        int row = rows.add(pair, x, y, impact, i, j);
        if (answered.length <= row) {
            answered = Arrays.copyOf(answered, rows.pair.length);
        }
        if (movedBy.length < bodies.type.length) {
            movedBy = Arrays.copyOf(movedBy, bodies.type.length);
        }
        movedBy[rows.bodyA[row]] = 0;
        movedBy[rows.bodyB[row]] = 0;
        answered[row] = NONE;
        return row;
    }

    /** What the last impacts took, in multiplications. */
    public double work() {
        return work;
    }

    /**
     * Changes the velocities of all bodies, and adds up the impulses of the pairs. Returns whether
     * the impacts have an answer: between a driven body and a wall nothing can part from both.
     */
    public boolean resolve() {
        boolean isAnswered = solve(Double.POSITIVE_INFINITY);
        keep(isAnswered);
        return isAnswered;
    }

    /**
     * Changes velocities alone. Returns whether passes came to an answer, for no more than so many
     * multiplications.
     */
    public boolean solve(double worth) {
        double settled = ROUND_OFF * fastest;
        double last = Double.POSITIVE_INFINITY;
        work = 0;
        for (int pass = 1; pass <= MOST_PASSES && work <= worth; pass++) {
            double change = pass();
            if (change <= settled) {
                return true;
            }
            if (pass % PASSES_EACH == 0 && change <= SHRINKS * last) {
                last = eliminate() ? change : 0;
            }
        }
        return false;
    }

    /** Returns whether there was something to be solved at once. */
    private boolean eliminate() {
        double multiplications = elimination.solve(fastest);
        work += multiplications;
        // All bodies have moved: every row is asked anew.
        Arrays.fill(answered, 0, rows.count, NONE);
        return multiplications > 0;
    }

    /** Adds up the impulses of the pairs, once they add no energy; or no speed, if unanswered. */
    public void keep(boolean isAnswered) {
        limitEnergy();
        if (!isAnswered) {
            limitSpeed();
        }
        for (int i = 0; i < rows.count; i++) {
            if (rows.points[i] == 0) {
                pairs.tellImpulse(rows.pair[i], rows.impulse[i]);
            }
        }
    }

    /** The work of impulses scaled by s is s·j·v + ½s²·j·Δv; it must not be positive. */
    private void limitEnergy() {
        double linear = 0;
        double quadratic = 0;
        for (int i = 0; i < rows.count; i++) {
            // What a running surface does to what it carries is work of its drive.
            double driven = rows.points[i] > 0 ? rows.target[i] : 0;
            linear += rows.impulse[i] * (rows.speedBefore[i] - driven);
            quadratic += rows.impulse[i] * (rows.speed(i) - rows.speedBefore[i]) / 2;
        }
        if (linear + quadratic > 0) {
            scale(Math.max(0, -linear / quadratic));
        }
    }

    /** Scales all impulses back until no row is much faster than the fastest one was. */
    private void limitSpeed() {
        double most = 0;
        for (int i = 0; i < rows.count; i++) {
            most = Math.max(most, Math.abs(rows.speedBefore[i]));
        }
        double limit = MOST_LEVERAGE * most;
        double share = 1;
        for (int i = 0; i < rows.count; i++) {
            double before = rows.speedBefore[i];
            double change = rows.speed(i) - before;
            if (Math.abs(before + share * change) > limit) {
                share = (limit - Math.abs(before)) / Math.abs(change);
            }
        }
        scale(share);
    }

    private void scale(double share) {
        for (int i = 0; i < rows.count; i++) {
            rows.push(i, (share - 1) * rows.impulse[i]);
        }
    }

    /**
     * One pass over all rows whose bodies have moved since they were solved last: an impact far
     * from them is none of their matter. Returns the largest change of speed, m/s.
     */
    private double pass() {
        double most = 0;
        int solved = 0;
        for (int i = 0; i < rows.count; i++) {
            if (Math.max(movedBy[rows.bodyA[i]], movedBy[rows.bodyB[i]]) > answered[i]) {
                most = Math.max(most, solveRow(i));
                solved++;
            }
        }
        work += WORK_OF_ROW * solved;
        return most;
    }

    private double solveRow(int i) {
        double old = rows.impulse[i];
        double wanted = old + (rows.target[i] - rows.speed(i)) / rows.response[i];
        double limited = rows.points[i] == 0 ? Math.max(0, wanted) : withinCone(i, wanted);
        double change = limited - old;
        if (change != 0) {
            rows.push(i, change);
            rows.impulse[i] = limited;
            changes++;
            noteMoved(rows.bodyA[i]);
            noteMoved(rows.bodyB[i]);
        }
        answered[i] = changes;
        return Math.abs(change) * rows.response[i];
    }

    private void noteMoved(int slot) {
        movedBy[slot] = bodies.isDynamic(slot) ? changes : 0;
    }

    private double withinCone(int tangent, double wanted) {
        double most = rows.cone(tangent);
        return Math.max(-most, Math.min(most, wanted));
    }
}
