package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongConsumer;
import java.util.stream.Stream;

/** Plays the games of a check, on one core or on all, and counts games and steps. */
final class Games {

    private final Cores cores;
    private final LongAdder played = new LongAdder();
    private final LongAdder steps = new LongAdder();
    private final LongConsumer told;

    /** The cores that a check may use. */
    enum Cores {
        /** Only the core of the calling thread, beside a game that a player plays. */
        ONE,
        ALL
    }

    /**
     * Games on some cores.
     *
     * @param told the number of games after each, on the thread that played it
     */
    Games(Cores cores, LongConsumer told) {
        this.cores = cores;
        this.told = told;
    }

    /** The elements of a list, as a stream on the chosen cores. */
    <T> Stream<T> each(List<T> some) {
        return cores == Cores.ONE ? some.stream() : some.parallelStream();
    }

    /**
     * Plays given clicks until the game ends.
     *
     * @throws CancellationException when the thread was interrupted, since the result is no longer
     *     wanted
     */
    Verdict play(Level level, Replay replay) {
        return play(new Trial(level, replay));
    }

    /** Plays a game to its end, as {@link #play(Level, Replay)} does. */
    Verdict play(Trial trial) {
        requireAwaited();
        int before = trial.game().steps();
        Verdict verdict = trial.play();
        count(verdict.steps() - before);
        return verdict;
    }

    /** Plays a part that games have in common, up to a step. */
    void playTo(Playback common, int step) {
        requireAwaited();
        steps.add(Math.max(0, step - common.game().steps()));
        common.stepTo(step);
    }

    private static void requireAwaited() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("the check was interrupted");
        }
    }

    /** Counts a game that was played elsewhere. */
    void count(int stepsOfIt) {
        played.increment();
        steps.add(stepsOfIt);
        told.accept(played());
    }

    /** Games played so far. */
    long played() {
        return played.sum();
    }

    /** Steps of all games so far. */
    long steps() {
        return steps.sum();
    }
}
