package rigibo.backend.storage;

import rigibo.backend.setup.StepStage;

import java.util.Arrays;

/** What the step in progress did and cost; the step's report is a view of it. */
public final class Counters {

    public int contacts;
    public int impacts;
    public int evaluations;
    public int rows;
    public int crushed;

    /** m, 0 or more. */
    public double deepestOverlap;

    /** Slots of bodies put to rest because their state stopped being finite. */
    public int[] quarantined = new int[16];

    public int quarantinedCount;

    /** ns per stage; all 0 without a clock. */
    public final long[] nanos = new long[StepStage.values().length];

    /** Begins a step. */
    public void clear() {
        contacts = 0;
        impacts = 0;
        evaluations = 0;
        rows = 0;
        crushed = 0;
        deepestOverlap = 0;
        quarantinedCount = 0;
        Arrays.fill(nanos, 0);
    }

    /** Notes a body that was put to rest, once. */
    void quarantine(int slot) {
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
