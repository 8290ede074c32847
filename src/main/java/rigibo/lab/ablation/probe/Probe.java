package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.lab.child.Fields;
import rigibo.lab.child.Interval;
import rigibo.lab.child.ThreadUse;
import rigibo.lab.child.Work;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/** The main class of the process: runs one workload and prints the result. */
public final class Probe {

    /** The beginning of the line with the sample. */
    public static final String MARK = "sample ";

    private static final double STEP = 1.0 / 60;

    /** The number of periods whose work is counted, and after which the state is hashed. */
    private static final int COUNTED_PERIODS = 2;

    private static final int FEWEST_TIMED_PERIODS = 3;
    private static final int MOST_TIMED_PERIODS = 100_000;
    private static final double NANOS_PER_MILLI = 1e6;

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
     * @param arguments its words, the seed of its random numbers, and the least times of warm-up
     *     and timing, ms
     */
    public static void main(String[] arguments) {
        Workload workload = new Workloads(Long.parseLong(arguments[1])).find(arguments[0]);
        double warm = Double.parseDouble(arguments[2]);
        double timed = Double.parseDouble(arguments[3]);
        System.out.println(MARK + Fields.line(new Probe(workload).measure(warm, timed)));
    }

    private Sample measure(double warmMillis, double timedMillis) {
        long begun = System.nanoTime();
        Work work = Work.NONE;
        for (int i = 0; i < COUNTED_PERIODS; i++) {
            work = work.plus(count());
        }
        long hash = pool.stateHash();
        while (System.nanoTime() - begun < warmMillis * NANOS_PER_MILLI) {
            poses.restore();
            run();
        }
        double[][] found = time(timedMillis);
        double nanos = Interval.of(found[0]).median();
        double bytes = DoubleStream.of(found[1]).min().orElseThrow();
        return new Sample(nanos, bytes, hash, work, pool.bitsPerBody());
    }

    private Work count() {
        poses.restore();
        Work work = Work.NONE;
        for (int i = 0; i < period; i++) {
            workload.drive().accept(pool);
            work = work.plus(Work.of(pool.step(STEP)));
        }
        return work;
    }

    private void run() {
        for (int i = 0; i < period; i++) {
            workload.drive().accept(pool);
            pool.step(STEP);
        }
    }

    /** Time in ns and bytes per step of every timed period, without the time to put bodies back. */
    private double[][] time(double millis) {
        double[] nanos = new double[MOST_TIMED_PERIODS];
        double[] bytes = new double[MOST_TIMED_PERIODS];
        long begun = System.nanoTime();
        int count = 0;
        while (count < FEWEST_TIMED_PERIODS
                || count < MOST_TIMED_PERIODS
                        && System.nanoTime() - begun < millis * NANOS_PER_MILLI) {
            poses.restore();
            // The clock may allocate, so it is read first and last.
            long before = ThreadUse.nanos();
            long allocated = ThreadUse.bytes();
            run();
            long taken = ThreadUse.bytes() - allocated;
            nanos[count] = (double) (ThreadUse.nanos() - before) / period;
            bytes[count] = (double) taken / period;
            count++;
        }
        return new double[][] {Arrays.copyOf(nanos, count), Arrays.copyOf(bytes, count)};
    }
}
