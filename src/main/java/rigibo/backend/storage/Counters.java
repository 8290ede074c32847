package rigibo.backend.storage;

import rigibo.backend.setup.SolveMethod;
import rigibo.backend.setup.StepStage;

import java.util.Arrays;

/**
 * Counters of the step in progress: what it did and what that cost. The report of the step is a
 * view of them.
 */
public final class Counters {

    public int contacts;
    public int impacts;
    public int evaluations;
    public int rows;
    public int crushed;
    public int cappedPairs;
    public int settledPairs;

    /** Islands, and their rows, by the method that solved them. */
    public final int[] islandsBy = new int[SolveMethod.values().length];

    public final int[] rowsBy = new int[SolveMethod.values().length];

    /** Number of times that a contact was solved in a pass, and multiplications in eliminations. */
    public long contactSolves;

    public double multiplications;

    /** Islands that several workers shared. */
    public int sharedIslands;

    /** Number of times that work was split among workers. */
    public int splits;

    /** Time that a core for each of several rehearsed workers would have saved, ns. */
    public long spared;

    /** Number of searches for what is around a body of a pile. */
    public int searches;

    /** Number of tests whether a shape is inside a sensor. */
    public int sensed;

    /** Deepest overlap, m, 0 or more. */
    public double deepestOverlap;

    /** Slots of bodies put to rest because their state stopped being finite. */
    public int[] quarantined = new int[16];

    public int quarantinedCount;

    /** Time per stage, ns; all 0 without a clock. */
    public final long[] nanos = new long[StepStage.values().length];

    /** Clears all counters at the start of a step. */
    public void clear() {
        contacts = 0;
        impacts = 0;
        evaluations = 0;
        rows = 0;
        crushed = 0;
        cappedPairs = 0;
        settledPairs = 0;
        Arrays.fill(islandsBy, 0);
        Arrays.fill(rowsBy, 0);
        contactSolves = 0;
        multiplications = 0;
        sharedIslands = 0;
        splits = 0;
        spared = 0;
        searches = 0;
        sensed = 0;
        deepestOverlap = 0;
        quarantinedCount = 0;
        Arrays.fill(nanos, 0);
    }

    /** Adds the work of an island solver, and clears it there. */
    public void take(IslandWork work) {
        impacts += work.impacts;
        crushed += work.crushed;
        contactSolves += work.contactSolves;
        multiplications += work.multiplications;
        for (int method = 0; method < rowsBy.length; method++) {
            rows += work.rowsBy[method];
            rowsBy[method] += work.rowsBy[method];
            islandsBy[method] += work.islandsBy[method];
        }
        work.clear();
    }

    /** Notes, once, a body that was put to rest. */
    public void quarantine(int slot) {
        for (int i = 0; i < quarantinedCount; i++) {
            if (quarantined[i] == slot) {
                return;
            }
        }
        if (quarantinedCount == quarantined.length) {
            quarantined = Arrays.copyOf(quarantined, 2 * quarantinedCount);
        }
        quarantined[quarantinedCount++] = slot;
    }
}
