package rigibo.lab.precision.probe;

import rigibo.lab.child.Interval;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.problem.Bench;
import rigibo.lab.problem.Problem;
import rigibo.lab.problem.StepTally;
import rigibo.lab.problem.Trial;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * Times a problem repeatedly, without its set-up. Settings take turns in one process, so that
 * compiled code and disturbances of the machine affect all of them alike. When each ran in its own
 * process, the same work differed by up to a factor of 2.8.
 */
final class Stopwatch {

    /**
     * The shortest turn, ms, long enough that the caches' state after the turn before does not
     * matter, even if the whole problem takes 30 µs.
     */
    private static final double TURN_MILLIS = 5;

    private static final double NANOS_PER_MILLI = 1e6;

    private final Patience patience;
    private final Problem problem;
    private final Engine engine;

    Stopwatch(Patience patience, Problem problem, Engine engine) {
        this.patience = patience;
        this.problem = problem;
        this.engine = engine;
    }

    /** The timing of each of one or more settings. */
    Map<Setting, Timing> time(List<Setting> settings) {
        long begun = System.nanoTime();
        while (millisSince(begun) < patience.warmMillis()) {
            settings.forEach(this::turn);
        }
        Map<Setting, List<StepTally>> turns = new LinkedHashMap<>();
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

    private static Timing timing(List<StepTally> turns) {
        Interval cpu = Interval.of(all(turns, StepTally::cpuMicros));
        return new Timing(
                turns.size(),
                cpu.median(),
                cpu.low(),
                cpu.high(),
                Interval.of(all(turns, StepTally::wallMicros)).median(),
                Interval.of(all(turns, StepTally::bytesPerStep)).median());
    }

    private static double[] all(List<StepTally> turns, ToDoubleFunction<StepTally> of) {
        return turns.stream().mapToDouble(of).toArray();
    }

    /** The number of runs of the whole problem. */
    private StepTally turn(Setting setting) {
        StepTally turn = new StepTally();
        long begun = System.nanoTime();
        do {
            run(setting, turn);
        } while (millisSince(begun) < TURN_MILLIS);
        return turn;
    }

    private void run(Setting setting, StepTally turn) {
        try (Bench bench = Bench.timed(engine, setting)) {
            Trial trial = problem.set(bench);
            turn.measure(
                    () -> {
                        trial.run();
                        return bench.steps();
                    });
        }
    }
}
