package rigibo.backend;

import rigibo.backend.setup.SolveMethod;
import rigibo.backend.setup.StepStage;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;

/**
 * What the last step did and cost. It is the pool's own object and is overwritten by the next step;
 * copy what must last.
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

    /** Dynamic and kinematic bodies that were simulated. */
    public int awake() {
        return data.roster.awakeCount;
    }

    /** Candidate pairs: bodies whose size fixtures overlap. */
    public int pairs() {
        return data.pairs.slots.inUse();
    }

    /**
     * Pairs that every column has room for. From three quarters of it on, steps that meet new pairs
     * copy column after column into one twice as long, and when the last one is done it doubles;
     * {@link Pool#reserve} makes room beforehand. It never shrinks.
     */
    public int pairRoom() {
        return data.pairs.room();
    }

    /** Pairs that touched. */
    public int contacts() {
        return counters.contacts;
    }

    /** Impacts that were resolved at their own time. */
    public int impacts() {
        return counters.impacts;
    }

    /** Evaluations of a distance in the search for times of impact. */
    public int evaluations() {
        return counters.evaluations;
    }

    /** Rows (normal, friction, rolling) of the contact solver. */
    public int rows() {
        return counters.rows;
    }

    /** How often a contact was solved in passes: some 60 multiplications each. */
    public long contactSolves() {
        return counters.contactSolves;
    }

    /** Multiplications by which small islands were solved whole. */
    public double multiplications() {
        return counters.multiplications;
    }

    /** Islands of touching bodies that got their answer by a method. */
    public int islands(SolveMethod method) {
        return counters.islandsBy[method.ordinal()];
    }

    /** Rows of those islands; of all methods together {@link #rows()}. */
    public int rows(SolveMethod method) {
        return counters.rowsBy[method.ordinal()];
    }

    /**
     * Pairs of bodies in flight that met as often as {@code Accuracy.maxImpactsPerPair} allows in a
     * step: what they would have done in the rest of it is left to the solver of piles, or to the
     * next step at a wall where they lose nothing.
     */
    public int cappedPairs() {
        return counters.cappedPairs;
    }

    /** Pairs of bodies in flight whose infinitely many bounces ended in their limit: Zeno's. */
    public int settledPairs() {
        return counters.settledPairs;
    }

    /** Deepest overlap of two bodies at the end of the step's contact search, m, 0 or more. */
    public double deepestOverlap() {
        return counters.deepestOverlap;
    }

    /** How often a shape was asked whether it is inside of a sensor that it is near. */
    public int sensed() {
        return data.counters.sensed;
    }

    /**
     * Pairs of a pile that overlapped deeper than 5 % of the width of the smaller of the two as the
     * step began: something had to give, because a body is driven or struck against what does not
     * move, or because there is no room. What is kinematic presses no further into a body that does
     * not follow it.
     */
    public int crushed() {
        return counters.crushed;
    }

    /** How many bodies were put to rest because their state stopped being finite. */
    public int quarantined() {
        return counters.quarantinedCount;
    }

    /** A body that was put to rest, from 0 to {@link #quarantined} − 1. */
    public RigidBody quarantined(int i) {
        return pool.handle(counters.quarantined[i]);
    }

    /** Time of a stage in ns; 0 unless the pool was given a clock. */
    public long nanos(StepStage stage) {
        return counters.nanos[stage.ordinal()];
    }
}
