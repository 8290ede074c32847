package rigibo.lab.precision.probe;

import com.sun.management.ThreadMXBean;

import rigibo.lab.child.Interval;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.problem.Bench;
import rigibo.lab.problem.Problem;
import rigibo.lab.problem.Trial;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * Times a problem over and over, without what it takes to set it. Settings take turns in one
 * process, so that what the compiler made of the engine and what else the machine does fall on all
 * of them alike. Each in a process of its own, the same work differed by up to a factor of 2.8.
 */
final class Stopwatch {

    /**
     * Shortest turn, ms. What the turn before left in the caches then does not count, even where
     * the whole problem takes 30 µs.
     */
    private static final double TURN_MILLIS = 5;

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final double NANOS_PER_MILLI = 1e6;
    private static final double NANOS_PER_MICRO = 1e3;

    private final Patience patience;
    private final Problem problem;
    private final Engine engine;

    /** Sums over the runs of a turn. */
    private static final class Turn {
        private long steps;
        private long cpuNanos;
        private long wallNanos;
        private long bytes;

        private double cpuMicros() {
            return cpuNanos / (NANOS_PER_MICRO * steps);
        }

        private double wallMicros() {
            return wallNanos / (NANOS_PER_MICRO * steps);
        }

        private double bytesPerStep() {
            return (double) bytes / steps;
        }
    }

    Stopwatch(Patience patience, Problem problem, Engine engine) {
        this.patience = patience;
        this.problem = problem;
        this.engine = engine;
    }

    /** What each of some settings takes, of one or more. */
    Map<Setting, Timing> time(List<Setting> settings) {
        long begun = System.nanoTime();
        while (millisSince(begun) < patience.warmMillis()) {
            settings.forEach(this::turn);
        }
        Map<Setting, List<Turn>> turns = new LinkedHashMap<>();
        settings.forEach(setting -> turns.put(setting, new ArrayList<>()));
        begun = System.nanoTime();
        int rounds = 0;
        do {
            turns.forEach((setting, taken) -> taken.add(turn(setting)));
            rounds++;
        } while (isWorthMore(rounds, millisSince(begun)));
        Map<Setting, Timing> timings = new LinkedHashMap<>();
        turns.forEach((setting, taken) -> timings.put(setting, timing(taken)));
        return timings;
    }

    private boolean isWorthMore(int rounds, double millis) {
        boolean isEnough = rounds >= patience.repeats() && millis >= patience.timedMillis();
        return !isEnough && millis < patience.mostMillis();
    }

    private static double millisSince(long begun) {
        return (System.nanoTime() - begun) / NANOS_PER_MILLI;
    }

    private static Timing timing(List<Turn> turns) {
        Interval cpu = Interval.of(all(turns, Turn::cpuMicros));
        return new Timing(
                turns.size(),
                cpu.median(),
                cpu.low(),
                cpu.high(),
                Interval.of(all(turns, Turn::wallMicros)).median(),
                Interval.of(all(turns, Turn::bytesPerStep)).median());
    }

    private static double[] all(List<Turn> turns, ToDoubleFunction<Turn> of) {
        return turns.stream().mapToDouble(of).toArray();
    }

    private Turn turn(Setting setting) {
        Turn turn = new Turn();
        long begun = System.nanoTime();
        do {
            run(setting, turn);
        } while (millisSince(begun) < TURN_MILLIS);
        return turn;
    }

    private void run(Setting setting, Turn turn) {
        try (Bench bench = Bench.timed(engine, setting)) {
            Trial trial = problem.set(bench);
            long wall = System.nanoTime();
            // The processor's clock may allocate, so bytes are counted within it.
            long cpu = processorNanos();
            long bytes = THREADS.getCurrentThreadAllocatedBytes();
            trial.run();
            turn.bytes += THREADS.getCurrentThreadAllocatedBytes() - bytes;
            turn.cpuNanos += processorNanos() - cpu;
            turn.wallNanos += System.nanoTime() - wall;
            turn.steps += bench.steps();
        }
    }

    /** What this thread has used of a processor: others that are given turns do not count. */
    private static long processorNanos() {
        return THREADS.isCurrentThreadCpuTimeSupported()
                ? THREADS.getCurrentThreadCpuTime()
                : System.nanoTime();
    }
}
