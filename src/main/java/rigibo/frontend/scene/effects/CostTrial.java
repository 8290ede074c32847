package rigibo.frontend.scene.effects;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.trial.Trial;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.LongSupplier;

/**
 * Compares the times of a step with two sets of effects: two pools of the same state, stepped in
 * turn, so that other work of the machine affects both alike. Everything is run twice and the
 * smaller time of each step counts: since the work is the same to the last bit, the larger one
 * contains an interruption. The result is the mean, not the median, because an occasional slow step
 * is the pool's own doing.
 */
final class CostTrial implements Trial<CostTrial.Result> {

    /** The first steps of a restored pool also lay out its scratch. */
    private static final int WARMING_STEPS = 2;

    /** Few, or the two pools would go ways of their own and no longer be the same scene. */
    private static final int MEASURED_STEPS = 8;

    private static final int RUNS = 2;

    /** Where a run begins, in steps: with two copies, each a piece of its own. */
    private static final int BEGIN = -WARMING_STEPS - 2;

    /** No step is begun any more once a run has taken so long, ns. */
    private static final long LONGEST_RUN = 300_000_000;

    private final byte[] snapshot;
    private final Effects effects;
    private final Effects switched;
    private final LongSupplier clock;
    private final long[] presentTimes = new long[MEASURED_STEPS];
    private final long[] otherTimes = new long[MEASURED_STEPS];
    private int steps = MEASURED_STEPS;
    private Pool present;
    private Pool other;

    /** Runs that are over, and the next step of the one that is not. */
    private int runs;

    private int step = BEGIN;
    private long runNanos;
    private long nanos;
    private boolean hasWoken;

    /**
     * A trial that has not begun.
     *
     * @param snapshot of the pool
     * @param effects simulated there; given beside the snapshot because functions are not in it
     * @param switched the other set
     * @param clock ns
     */
    CostTrial(byte[] snapshot, Effects effects, Effects switched, LongSupplier clock) {
        this.snapshot = snapshot;
        this.effects = effects;
        this.switched = switched;
        this.clock = clock;
        Arrays.fill(presentTimes, Long.MAX_VALUE);
        Arrays.fill(otherTimes, Long.MAX_VALUE);
    }

    /**
     * The result of a trial.
     *
     * @param step a step with the present effects, ns
     * @param difference additional time of a step with the other set, ns
     * @param hasWoken whether sleeping bodies were woken for it
     * @param nanos time of the whole trial, ns
     */
    record Result(double step, double difference, boolean hasWoken, long nanos) {}

    /** Makes one of two copies, or a step of each. */
    @Override
    public Optional<Result> goOn() {
        long begin = clock.getAsLong();
        if (step == BEGIN) {
            present = Pool.restore(snapshot, effects);
        } else if (step < -WARMING_STEPS) {
            copyOther();
        } else {
            makeSteps();
        }
        step++;
        long took = clock.getAsLong() - begin;
        nanos += took;
        runNanos += took;
        if (step > 0 && runNanos > LONGEST_RUN) {
            steps = step;
        }
        if (step >= steps) {
            runs++;
            step = BEGIN;
            runNanos = 0;
        }
        return runs == RUNS ? Optional.of(result()) : Optional.empty();
    }

    private void copyOther() {
        other = Pool.restore(snapshot, effects);
        other.effects(switched);
        boolean isSleepSwitched = effects.declares(Sleep.class) != switched.declares(Sleep.class);
        hasWoken = !isSleepSwitched && sleeps(present);
        if (hasWoken) {
            // Changing the effects wakes everybody, so the other pool is woken, too.
            present.effects(effects);
        }
    }

    private void makeSteps() {
        // Whoever goes second finds warm caches: they take turns.
        boolean isFirst = step % 2 == 0;
        long early = time(isFirst ? present : other);
        long late = time(isFirst ? other : present);
        if (step >= 0) {
            presentTimes[step] = Math.min(presentTimes[step], isFirst ? early : late);
            otherTimes[step] = Math.min(otherTimes[step], isFirst ? late : early);
        }
    }

    private Result result() {
        double mean = mean(presentTimes);
        return new Result(mean, mean(otherTimes) - mean, hasWoken, nanos);
    }

    private static boolean sleeps(Pool pool) {
        for (RigidBody body : pool.bodies()) {
            if (body.type() == BodyType.DYNAMIC && !body.isAwake()) {
                return true;
            }
        }
        return false;
    }

    private long time(Pool pool) {
        long begin = clock.getAsLong();
        pool.step(Scene.STEP);
        return clock.getAsLong() - begin;
    }

    /** Mean over the measured steps. */
    private double mean(long[] times) {
        return Arrays.stream(times, 0, steps).average().orElseThrow();
    }
}
