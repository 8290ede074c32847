package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.frontend.scene.trial.Subject;
import rigibo.frontend.scene.trial.Trials;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/**
 * Measures at intervals, on copies of a running scene, what the present accuracy costs and how far
 * it is from EXACT. The game's thread never waits.
 */
public final class AccuracyMeter {

    /** Snapshots take at most this part of the game's time, as 1 in n. */
    private static final long SNAPSHOT_SHARE = 2000;

    /** Pause after a trial, as a multiple of the trial's time; and the shortest pause, ns. */
    private static final long REST = 8;

    private static final long SHORTEST_REST = 1_000_000_000;

    /** Trials over which the price is smoothed: the machine is never quite quiet. */
    private static final double SMOOTHING = 4;

    private final Trials trials;
    private Subject subject;
    private CompletableFuture<AccuracyTrial.Result> trial;
    private AccuracyTrial.Result last;
    private double price;
    private long due;

    /** A meter whose trials run there. */
    public AccuracyMeter(Trials trials) {
        this.trials = trials;
    }

    /** Takes in the last measurement and starts the next one. To be called between steps. */
    void turn(Pool pool) {
        Subject now = Subject.of(pool);
        if (!now.equals(subject)) {
            subject = now;
            trial = null;
            last = null;
            due = now();
        }
        collect();
        if (trial == null && now() >= due) {
            start();
        }
    }

    private void start() {
        byte[] snapshot = trials.snapshot(subject, SNAPSHOT_SHARE);
        Subject of = subject;
        trial =
                trials.start(
                        new AccuracyTrial(
                                snapshot,
                                of.effects(),
                                of.accuracy(),
                                trials.clock(),
                                trials.mostPiece()));
    }

    private void collect() {
        if (trial == null || !trial.isDone()) {
            return;
        }
        AccuracyTrial.Result result = trial.join();
        price = last == null ? result.price() : price + (result.price() - price) / SMOOTHING;
        last = result;
        long rest = REST * result.nanos() * Math.max(1, result.longest() / trials.unseen());
        due = now() + Math.max(SHORTEST_REST, rest);
        trial = null;
    }

    private long now() {
        return trials.clock().getAsLong();
    }

    /** The last trial; none before the first. */
    Optional<AccuracyTrial.Result> last() {
        return Optional.ofNullable(last);
    }

    /** How many times as long as at DRAFT a step takes. */
    double price() {
        return price;
    }
}
