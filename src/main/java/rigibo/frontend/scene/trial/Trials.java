package rigibo.frontend.scene.trial;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Runs trials, and keeps the snapshot from which they start. Several meters share it: their trials
 * queue for one thread, so that no two disturb each other, and one snapshot serves all of them.
 */
public final class Trials {

    /** A snapshot is taken again after so long at the earliest, ns. */
    private static final long SNAPSHOT_PERIOD = 1_000_000_000;

    /** Takes pieces one after the other, as long as there is another one. */
    private final Consumer<BooleanSupplier> runner;

    private final LongSupplier clock;
    private final Runnable end;
    private Subject subject;
    private byte[] snapshot;
    private long taken;
    private long nanos;

    private Trials(Consumer<BooleanSupplier> runner, LongSupplier clock, Runnable end) {
        this.runner = runner;
        this.clock = clock;
        this.end = end;
    }

    /** Trials that are run by {@code runner} and timed by a clock in ns. */
    public static Trials on(Executor runner, LongSupplier clock) {
        return new Trials(pieces -> runner.execute(() -> all(pieces)), clock, () -> {});
    }

    /** Trials with a thread of their own, which begins with the first of them. */
    public static Trials inBackground() {
        Background thread = new Background();
        return new Trials(thread::take, System::nanoTime, thread::close);
    }

    /** Ends the thread; call when the scene is over. */
    public void close() {
        end.run();
    }

    /** The clock that times trials, ns. */
    public LongSupplier clock() {
        return clock;
    }

    /**
     * Time of a piece from which on pictures are late by it, ns: whoever makes longer ones rests
     * longer, in proportion.
     */
    public long unseen() {
        return Background.unseen();
    }

    /** Time of a piece from which on the world loses time by it, ns: no trial makes two of them. */
    public long mostPiece() {
        return Background.mostPiece();
    }

    /** Hands a trial over; it is done when the thread has come to it. */
    public <R> CompletableFuture<R> start(Trial<R> trial) {
        CompletableFuture<R> outcome = new CompletableFuture<>();
        runner.accept(() -> goesOn(trial, outcome));
        return outcome;
    }

    private static <R> boolean goesOn(Trial<R> trial, CompletableFuture<R> outcome) {
        try {
            Optional<R> found = trial.goOn();
            found.ifPresent(outcome::complete);
            return found.isEmpty();
        } catch (RuntimeException broken) {
            outcome.completeExceptionally(broken);
            return false;
        }
    }

    /** Does all pieces of a trial at once. */
    static void all(BooleanSupplier pieces) {
        boolean isAnother = true;
        while (isAnother) {
            isAnother = pieces.getAsBoolean();
        }
    }

    /**
     * A snapshot of a scene, as fresh as its cost permits.
     *
     * @param of the scene; a snapshot of another scene than before is taken at once
     * @param share snapshots take at most this part of the game's time, as 1 in n; one of 600 discs
     *     takes 4 ms
     */
    public byte[] snapshot(Subject of, long share) {
        long begin = clock.getAsLong();
        long period = Math.max(SNAPSHOT_PERIOD, share * nanos);
        if (!of.equals(subject) || begin - taken >= period) {
            subject = of;
            snapshot = of.pool().snapshot();
            taken = clock.getAsLong();
            nanos = taken - begin;
        }
        return snapshot;
    }
}
