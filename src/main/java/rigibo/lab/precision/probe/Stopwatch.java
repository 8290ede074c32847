package rigibo.lab.precision.probe;

import com.sun.management.ThreadMXBean;

import rigibo.lab.child.Interval;
import rigibo.lab.problem.Bench;
import rigibo.lab.problem.Problem;
import rigibo.lab.problem.Trial;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;

/** Times a problem over and over, without what it takes to set it. */
final class Stopwatch {

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final double NANOS_PER_MILLI = 1e6;
    private static final double NANOS_PER_MICRO = 1e3;

    private final Patience patience;

    /** One repeat, by step: µs of the processor, µs by the clock on the wall, bytes. */
    private record Lap(double cpu, double wall, double bytes) {}

    Stopwatch(Patience patience) {
        this.patience = patience;
    }

    /**
     * Times the problem on benches as they are given out, each closed after its run.
     *
     * @param warmSince when the problem began to be run, ns of the system's clock
     */
    Timing time(Problem problem, long warmSince, Supplier<Bench> benches) {
        while (millisSince(warmSince) < patience.warmMillis()) {
            lap(problem, benches);
        }
        List<Lap> laps = new ArrayList<>();
        long begun = System.nanoTime();
        do {
            laps.add(lap(problem, benches));
        } while (isWorthMore(laps.size(), millisSince(begun)));
        Interval cpu = Interval.of(all(laps, Lap::cpu));
        return new Timing(
                laps.size(),
                cpu.median(),
                cpu.low(),
                cpu.high(),
                Interval.of(all(laps, Lap::wall)).median(),
                Interval.of(all(laps, Lap::bytes)).median());
    }

    private boolean isWorthMore(int laps, double millis) {
        boolean isEnough = laps >= patience.repeats() && millis >= patience.timedMillis();
        return !isEnough && millis < patience.mostMillis();
    }

    private static double millisSince(long begun) {
        return (System.nanoTime() - begun) / NANOS_PER_MILLI;
    }

    private static double[] all(List<Lap> laps, ToDoubleFunction<Lap> of) {
        return laps.stream().mapToDouble(of).toArray();
    }

    private static Lap lap(Problem problem, Supplier<Bench> benches) {
        try (Bench bench = benches.get()) {
            Trial trial = problem.set(bench);
            long wall = System.nanoTime();
            // The processor's clock may allocate, so bytes are counted within it.
            long cpu = processorNanos();
            long bytes = THREADS.getCurrentThreadAllocatedBytes();
            trial.run();
            bytes = THREADS.getCurrentThreadAllocatedBytes() - bytes;
            cpu = processorNanos() - cpu;
            wall = System.nanoTime() - wall;
            double micros = NANOS_PER_MICRO * bench.steps();
            return new Lap(cpu / micros, wall / micros, (double) bytes / bench.steps());
        }
    }

    /** What this thread has used of a processor: others that are given turns do not count. */
    private static long processorNanos() {
        return THREADS.isCurrentThreadCpuTimeSupported()
                ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime();
    }
}
