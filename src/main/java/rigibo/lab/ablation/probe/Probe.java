package rigibo.lab.ablation.probe;

import com.sun.management.ThreadMXBean;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;

import java.lang.management.ManagementFactory;
import java.util.Arrays;

/** The process: runs one workload and prints what it found. */
public final class Probe {

    /** What the line with the sample begins with. */
    public static final String MARK = "sample ";

    private static final double STEP = 1.0 / 60;

    /** Periods that are counted, and after which the state is hashed. */
    private static final int COUNTED_PERIODS = 2;

    private static final int FEWEST_TIMED_PERIODS = 3;
    private static final int MOST_TIMED_PERIODS = 100_000;
    private static final double NANOS_PER_MILLI = 1e6;

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private final Workload workload;
    private final Pool pool;
    private final Poses poses;
    private final int period;

    private Probe(Workload workload) {
        this.workload = workload;
        period = workload.period();
        pool = new Pool(workload.effects(), Accuracy.GAME);
        workload.bodies().forEach(pool::add);
        for (int i = 0; i < workload.stepsToSettle(); i++) {
            workload.drive().accept(pool);
            pool.step(STEP);
        }
        poses = new Poses(pool);
    }

    /**
     * Measures a workload.
     *
     * @param arguments its words, the seed of its chance, and for how long it warms up and is timed
     *     at least, both ms
     */
    public static void main(String[] arguments) {
        Workload workload = new Workloads(Long.parseLong(arguments[1])).find(arguments[0]);
        double warm = Double.parseDouble(arguments[2]);
        double timed = Double.parseDouble(arguments[3]);
        System.out.println(MARK + new Probe(workload).measure(warm, timed).line());
    }

    private Sample measure(double warmMillis, double timedMillis) {
        long begun = System.nanoTime();
        Counts counts = Counts.NONE;
        for (int i = 0; i < COUNTED_PERIODS; i++) {
            counts = count(counts);
        }
        long hash = pool.stateHash();
        while (System.nanoTime() - begun < warmMillis * NANOS_PER_MILLI) {
            poses.restore();
            run();
        }
        double[][] found = time(timedMillis);
        return new Sample(median(found[0]), least(found[1]), hash, counts, pool.bitsPerBody());
    }

    private Counts count(Counts before) {
        poses.restore();
        Counts counts = before;
        for (int i = 0; i < period; i++) {
            workload.drive().accept(pool);
            counts = counts.plus(pool.step(STEP));
        }
        return counts;
    }

    private void run() {
        for (int i = 0; i < period; i++) {
            workload.drive().accept(pool);
            pool.step(STEP);
        }
    }

    /** ns and bytes per step of every timed period; putting bodies back is not timed. */
    private double[][] time(double millis) {
        double[] nanos = new double[MOST_TIMED_PERIODS];
        double[] bytes = new double[MOST_TIMED_PERIODS];
        long begun = System.nanoTime();
        int count = 0;
        while (count < FEWEST_TIMED_PERIODS
                || count < MOST_TIMED_PERIODS
                        && System.nanoTime() - begun < millis * NANOS_PER_MILLI) {
            poses.restore();
            // The clock may allocate, so it is asked first and last.
            long before = processorNanos();
            long allocated = THREADS.getCurrentThreadAllocatedBytes();
            run();
            long taken = THREADS.getCurrentThreadAllocatedBytes() - allocated;
            nanos[count] = (double) (processorNanos() - before) / period;
            bytes[count] = (double) taken / period;
            count++;
        }
        return new double[][] {Arrays.copyOf(nanos, count), Arrays.copyOf(bytes, count)};
    }

    /** What this thread has used of a processor: others that are given turns do not count. */
    private static long processorNanos() {
        return THREADS.isCurrentThreadCpuTimeSupported()
                ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime();
    }

    private static double least(double[] values) {
        return Arrays.stream(values).min().orElseThrow();
    }

    private static double median(double[] values) {
        Arrays.sort(values);
        int half = values.length / 2;
        return values.length % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
    }
}
