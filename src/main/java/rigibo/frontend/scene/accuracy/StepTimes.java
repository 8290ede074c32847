package rigibo.frontend.scene.accuracy;

import rigibo.backend.StepReport;
import rigibo.backend.setup.StepStage;

import java.util.Arrays;

/** Times of the steps in the last second. */
public final class StepTimes {

    private static final int WINDOW = 60;

    private final long[] nanos = new long[WINDOW];
    private int count;

    /** Takes a step's, from the clock of the pool. */
    public void add(StepReport report) {
        long sum = 0;
        for (StepStage stage : StepStage.values()) {
            sum += report.nanos(stage);
        }
        nanos[count % WINDOW] = sum;
        count++;
    }

    /** Begins anew. */
    public void forget() {
        count = 0;
    }

    /** Time of the last step, ns; 0 before the first. */
    public long last() {
        return count == 0 ? 0 : nanos[(count - 1) % WINDOW];
    }

    /** ns; 0 while there is none. A median: what the machine does besides is no step's doing. */
    public double median() {
        int size = Math.min(count, WINDOW);
        long[] sorted = Arrays.copyOf(nanos, size);
        Arrays.sort(sorted);
        return size == 0 ? 0 : sorted[size / 2];
    }
}
