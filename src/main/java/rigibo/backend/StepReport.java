package rigibo.backend;

import rigibo.backend.setup.SolveMethod;
import rigibo.backend.setup.StepStage;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;

/**
 * What the last step did and cost. The pool has one report and overwrites it in every step: copy
 * what must last.
 *
 * <pre>{@code
 * StepReport report = pool.step(1.0 / 60);
 * System.out.println(report.awake() + " awake, overlap " + report.deepestOverlap() + " m");
 * }</pre>
 */
public final class StepReport {

    private final Pool pool;
    private final DataStorage data;
    private final Counters counters;

    StepReport(Pool pool, DataStorage data) {
        this.pool = pool;
        this.data = data;
        counters = data.counters;
    }

    /** Bodies in the pool. */
    public int bodies() {
        return data.bodies.count();
    }

    /** Dynamic and kinematic bodies that were awake and so were simulated. */
    public int awake() {
        return data.roster.awakeCount;
    }

    /** Candidate pairs: bodies whose size fixtures overlap. */
    public int pairs() {
        return data.pairs.slots.inUse();
    }

    /**
     * Capacity of the columns of pairs. Once three quarters are used, steps that find new pairs
     * grow the columns one after the other, and the capacity doubles when all are grown. It never
     * shrinks. {@link Pool#reserve} grows them beforehand.
     */
    public int pairRoom() {
        return data.pairs.room();
    }

    /** Pairs that touched. */
    public int contacts() {
        return counters.contacts;
    }

    /** Impacts that were resolved at their own time within the step. */
    public int impacts() {
        return counters.impacts;
    }

    /** Distance evaluations in the search for times of impact. */
    public int evaluations() {
        return counters.evaluations;
    }

    /** Rows (normal, friction, rolling) of the contact solver. */
    public int rows() {
        return counters.rows;
    }

    /** Contacts solved in passes, each counted once per pass: about 60 multiplications each. */
    public long contactSolves() {
        return counters.contactSolves;
    }

    /** Multiplications spent on eliminations, of islands and of simultaneous impacts. */
    public double multiplications() {
        return counters.multiplications;
    }

    /** Islands that were solved by the given method. */
    public int islands(SolveMethod method) {
        return counters.islandsBy[method.ordinal()];
    }

    /**
     * Islands that workers shared; 0 with one worker, and where there was too little to share. Of
     * all counts only this one and {@link #splits()} depend on {@link Pool#workers(int)}.
     */
    public int sharedIslands() {
        return counters.sharedIslands;
    }

    /**
     * How often work was split among workers: islands, pairs, or contacts of one colour. It is 0
     * with one worker, and where there was too little to share.
     */
    public int splits() {
        return counters.splits;
    }

    /**
     * Time in ns by which the step would have been shorter with a core for each worker of {@link
     * Pool#rehearse(int)}; 0 without a rehearsal. The rest of the step's time is the critical path:
     * work that has to be done in order, and the longest share of all other work.
     */
    public long spared() {
        return counters.spared;
    }

    /**
     * Solver rows of the islands that were solved by the given method; all together {@link
     * #rows()}.
     */
    public int rows(SolveMethod method) {
        return counters.rowsBy[method.ordinal()];
    }

    /**
     * Pairs of bodies in flight that reached {@code Accuracy.maxImpactsPerPair} impacts within the
     * step. For the rest of the step the solver of piles takes them over; at a wall with an
     * elasticity of 1 the body waits for the next step.
     */
    public int cappedPairs() {
        return counters.cappedPairs;
    }

    /**
     * Pairs of bodies in flight whose bounces ended by Zeno's limit: infinitely many in finite
     * time.
     */
    public int settledPairs() {
        return counters.settledPairs;
    }

    /** Deepest overlap of two bodies that the step's contact search found, m, 0 or more. */
    public double deepestOverlap() {
        return counters.deepestOverlap;
    }

    /**
     * Searches for bodies in flight around bodies of piles. A body that is struck or led off its
     * path takes one or two, a body at rest none.
     */
    public int searches() {
        return counters.searches;
    }

    /** Tests of whether a shape is inside a sensor whose fixture it overlaps. */
    public int sensed() {
        return counters.sensed;
    }

    /**
     * Pairs of a pile that overlap by more than 5 % of the smaller body's width. This happens when
     * a body is driven or struck against an obstacle that cannot yield, or when there is no room. A
     * kinematic body presses no further into a crushed body that does not move along with it.
     */
    public int crushed() {
        return counters.crushed;
    }

    /** Number of bodies that were put to rest because their state stopped being finite. */
    public int quarantined() {
        return counters.quarantinedCount;
    }

    /** The i-th body that was put to rest, i from 0 to {@link #quarantined()} − 1. */
    public RigidBody quarantined(int i) {
        return pool.handle(counters.quarantined[i]);
    }

    /** Time that a stage took, ns; 0 unless the pool was given a clock. */
    public long nanos(StepStage stage) {
        return counters.nanos[stage.ordinal()];
    }
}
