package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Scene;

import java.util.List;
import java.util.function.LongSupplier;

/**
 * Half a second of a scene, simulated from the same state three times without input: at the present
 * accuracy, at DRAFT and at EXACT. The three are stepped in turn, so that other work of the machine
 * affects all of them alike.
 */
final class AccuracyTrial {

    /** Half a second: longer, and of a chaotic scene only the chaos would be told. */
    static final int STEPS = 30;

    /** The first steps of a restored pool also lay out its scratch: they are not timed. */
    private static final int WARMING_STEPS = 2;

    /** No round is begun any more once a trial has taken so long, ns, and its price is known. */
    private static final long LONGEST = 500_000_000;

    private static final int FEWEST_STEPS = WARMING_STEPS + 2;

    private final LongSupplier clock;
    private final Pool present;
    private final Pool draft;
    private final Pool exact;
    private long presentNanos;
    private long draftNanos;

    private AccuracyTrial(byte[] snapshot, Effects effects, Accuracy accuracy, LongSupplier clock) {
        this.clock = clock;
        present = copy(snapshot, effects, accuracy);
        draft = copy(snapshot, effects, Accuracy.DRAFT);
        exact = copy(snapshot, effects, Accuracy.EXACT);
    }

    /**
     * The result of a trial.
     *
     * @param price time of a step as a multiple of that at DRAFT; NaN where no time was measured
     * @param error root mean square, over the dynamic bodies, of the distance to their places at
     *     EXACT, m
     * @param steps that were made
     * @param nanos time of the whole trial, ns
     */
    record Result(double price, double error, int steps, long nanos) {

        /** Whether it went the whole way, or was cut short because the scene is slow. */
        boolean isWhole() {
            return steps == STEPS;
        }
    }

    /**
     * Runs one.
     *
     * @param snapshot of the pool
     * @param effects simulated there; given beside the snapshot because functions are not in it
     * @param accuracy the present one
     * @param clock ns
     */
    static Result run(byte[] snapshot, Effects effects, Accuracy accuracy, LongSupplier clock) {
        long begin = clock.getAsLong();
        AccuracyTrial trial = new AccuracyTrial(snapshot, effects, accuracy, clock);
        int steps = 0;
        while (steps < FEWEST_STEPS || steps < STEPS && clock.getAsLong() - begin < LONGEST) {
            trial.round(steps >= WARMING_STEPS);
            steps++;
        }
        double price = (double) trial.presentNanos / trial.draftNanos;
        return new Result(price, trial.error(), steps, clock.getAsLong() - begin);
    }

    private static Pool copy(byte[] snapshot, Effects effects, Accuracy accuracy) {
        Pool pool = Pool.restore(snapshot, effects);
        pool.accuracy(accuracy);
        return pool;
    }

    private void round(boolean isTimed) {
        long ofPresent = time(present);
        long ofDraft = time(draft);
        exact.step(Scene.STEP);
        if (isTimed) {
            presentNanos += ofPresent;
            draftNanos += ofDraft;
        }
    }

    private long time(Pool pool) {
        long begin = clock.getAsLong();
        pool.step(Scene.STEP);
        return clock.getAsLong() - begin;
    }

    private double error() {
        List<RigidBody> here = present.bodies();
        List<RigidBody> there = exact.bodies();
        double squares = 0;
        int count = 0;
        for (int i = 0; i < here.size(); i++) {
            if (here.get(i).type() == BodyType.DYNAMIC) {
                double dx = here.get(i).x() - there.get(i).x();
                double dy = here.get(i).y() - there.get(i).y();
                squares += dx * dx + dy * dy;
                count++;
            }
        }
        return Math.sqrt(squares / Math.max(1, count));
    }
}
