package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.generate.Generated;
import rigibo.frontend.puzzle.generate.Generator;
import rigibo.frontend.puzzle.level.Level;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/** Makes a level on a thread of its own, so that no window waits. */
public final class Making {

    private final List<Long> seeds;
    private final Thread thread = new Thread(this::make, "making a level");
    private volatile Optional<Made> made = Optional.empty();
    private volatile Optional<Generated.Effort> effort = Optional.empty();
    private volatile boolean isHopeless;

    /**
     * A level that was made.
     *
     * @param seed whose level it is
     * @param level decided by the seed
     */
    public record Made(long seed, Level level) {

        /** A level that states the seed from which it was made. */
        static Made of(Level level) {
            return new Made(level.origin().orElseThrow().seed(), level);
        }
    }

    private Making(List<Long> seeds) {
        this.seeds = List.copyOf(seeds);
    }

    /** Begins to make the level of the first of some seeds that has one. */
    public static Making begin(List<Long> seeds) {
        Making making = new Making(seeds);
        making.thread.setDaemon(true);
        // A game in play has precedence.
        making.thread.setPriority(Thread.MIN_PRIORITY);
        making.thread.start();
        return making;
    }

    private void make() {
        Generator generator = new Generator(now -> effort = Optional.of(now));
        try {
            made = generator.first(seeds).map(Generated::level).map(Made::of);
            isHopeless = made.isEmpty();
        } catch (CancellationException stopped) {
            // The result is no longer wanted.
            made = Optional.empty();
        }
    }

    /** The level; empty while it is being made. */
    public Optional<Made> made() {
        return made;
    }

    /** The work so far on the present seed; empty before the first game. */
    public Optional<Generated.Effort> effort() {
        return effort;
    }

    /** Whether none of the seeds has a level. */
    public boolean isHopeless() {
        return isHopeless;
    }

    /** Stops within a game of the check, unless the level is made. */
    public void stop() {
        thread.interrupt();
    }

    /** Waits until it has ended or was stopped; for tests. */
    public void await() throws InterruptedException {
        thread.join();
    }
}
