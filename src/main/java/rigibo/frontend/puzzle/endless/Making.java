package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.generate.Generator;
import rigibo.frontend.puzzle.level.Level;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/** A level being made on a thread of its own, so that no window waits for it. */
public final class Making {

    private final List<Long> seeds;
    private final Thread thread = new Thread(this::make, "making a level");
    private volatile Optional<Made> made = Optional.empty();
    private volatile boolean isHopeless;

    /**
     * A level that was made.
     *
     * @param seed that it is the level of
     * @param level as the seed decides it
     */
    public record Made(long seed, Level level) {}

    private Making(List<Long> seeds) {
        this.seeds = List.copyOf(seeds);
    }

    /** Begins to make the level of the first of some seeds that has one. */
    public static Making begin(List<Long> seeds) {
        Making making = new Making(seeds);
        making.thread.setDaemon(true);
        // Whoever plays meanwhile goes first.
        making.thread.setPriority(Thread.MIN_PRIORITY);
        making.thread.start();
        return making;
    }

    private void make() {
        Generator generator = new Generator();
        try {
            for (long seed : seeds) {
                made = generator.level(seed).map(found -> new Made(seed, found.level()));
                if (made.isPresent()) {
                    return;
                }
            }
            isHopeless = true;
        } catch (CancellationException stopped) {
            // Nobody waits any more.
            made = Optional.empty();
        }
    }

    /** The level; empty as long as it is being made. */
    public Optional<Made> made() {
        return made;
    }

    /** Whether none of the seeds has a level. */
    public boolean isHopeless() {
        return isHopeless;
    }

    /** Stops within a game of the check, unless it is done. */
    public void stop() {
        thread.interrupt();
    }

    /** Waits until it is done or stopped; for tests. */
    public void await() throws InterruptedException {
        thread.join();
    }
}
