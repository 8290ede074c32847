package rigibo.backend.impact;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

import java.util.Arrays;

/**
 * Resolves impacts that happen at the same time and share bodies, all at once. Resolved one after
 * the other, the first of two equal impacts would get a larger impulse than the second.
 *
 * <p>Every point requires vₙ' ≥ −e·vₙ and j ≥ 0, one of them with equality, and every pair |jₜ| ≤
 * μ·Σjₙ. Passes over the rows are repeated until nothing changes (projected Gauss–Seidel, which
 * converges for such problems; R. W. Cottle et al., The Linear Complementarity Problem, 1992, ch.
 * 5). With e = 1 and μ = 0 the limit keeps the energy, as a single impact does. Where friction
 * would add energy, all impulses are scaled down.
 */
public final class TiedImpacts {

    /** Number of passes after which the impacts count as having no solution. */
    private static final int MOST_PASSES = 300;

    /**
     * Change of speed up to which a pass counts as the last, as a share of the fastest approach.
     */
    private static final double SETTLED = 1e-14;

    /**
     * Greatest speed that impacts without a solution may leave, as a multiple of the fastest row's.
     */
    private static final double MOST_LEVERAGE = 2;

    /** Passes between two eliminations, which find the active rows again. */
    private static final int PASSES_EACH = 4;

    /**
     * Share to which the residual must have shrunk since the last elimination; otherwise it cycles.
     */
    private static final double SHRINKS = 0.5;

    /** Cost of solving a row in a pass, in multiplications of an elimination. */
    static final int WORK_OF_ROW = 60;

    private final Bodies bodies;
    private final Pairs pairs;
    private final TiedRows rows;
    private final TiedElimination elimination;

    private double fastest;
    private double work;

    /** Number of row solutions so far that changed an impulse. */
    private int changes;

    /** By slot: number of the last change that moved the body. */
    private int[] movedBy = new int[16];

    /** By row: number of the last change that the row has taken into account. */
    private int[] answered = new int[16];

    private static final int NONE = -1;

    /** Impacts between bodies of these columns. */
    public TiedImpacts(Bodies bodies, Pairs pairs) {
        this.bodies = bodies;
        this.pairs = pairs;
        rows = new TiedRows(bodies, pairs);
        elimination = new TiedElimination(rows);
    }

    /** Starts the next set of impacts. */
    public void clear() {
        rows.count = 0;
        fastest = 0;
        changes = 0;
    }

    /** Adds the impact of a pair, to be resolved with the given elasticity; nothing changes yet. */
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

    /** Multiplications that the last set of impacts took. */
    public double work() {
        return work;
    }

    /**
     * Changes the velocities of all bodies and adds the impulses to the pairs. Returns whether the
     * impacts have a solution: a body between a driven body and a wall cannot part from both.
     */
    public boolean resolve() {
        boolean isAnswered = solve(Double.POSITIVE_INFINITY);
        keep(isAnswered);
        return isAnswered;
    }

    /**
     * Changes velocities only. Returns whether the passes converged within {@code worth}
     * multiplications.
     */
    public boolean solve(double worth) {
        double settled = SETTLED * fastest;
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

    /** Makes an elimination; returns whether there were active rows to solve. */
    private boolean eliminate() {
        double multiplications = elimination.solve(fastest);
        work += multiplications;
        // All bodies may have moved: every row is due again.
        Arrays.fill(answered, 0, rows.count, NONE);
        return multiplications > 0;
    }

    /**
     * Limits the energy (without a solution, also the speed), then adds the impulses to the pairs.
     */
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
            // The work of a running surface is done by its drive and is not counted.
            double driven = rows.points[i] > 0 ? rows.target[i] : 0;
            linear += rows.impulse[i] * (rows.speedBefore[i] - driven);
            quadratic += rows.impulse[i] * (rows.speed(i) - rows.speedBefore[i]) / 2;
        }
        if (linear + quadratic > 0) {
            scale(Math.max(0, -linear / quadratic));
        }
    }

    /** Scales all impulses down until no row exceeds {@link #MOST_LEVERAGE} times the fastest. */
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
     * One pass over all rows whose bodies have moved since the row was last solved; other rows
     * cannot have changed. Returns the largest change of speed, m/s.
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
