package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.List;
import java.util.stream.IntStream;

/**
 * A stored solution played as the file states it and with everything a little aside.
 *
 * @param stated the level as it is
 * @param jittered by seed
 */
record SolutionTrials(Verdict stated, List<Verdict> jittered) {

    /** Seeds tried per solution. */
    static final int SEEDS = 50;

    static SolutionTrials of(Level level, Solution solution, Accuracy accuracy) {
        List<Verdict> jittered =
                IntStream.range(0, SEEDS)
                        .parallel()
                        .mapToObj(seed -> play(Jitter.of(level, seed), solution, accuracy))
                        .toList();
        return new SolutionTrials(play(level, solution, accuracy), jittered);
    }

    private static Verdict play(Level level, Solution solution, Accuracy accuracy) {
        return Trial.play(level, Replay.of(level, solution, accuracy));
    }

    int wins() {
        return (int) jittered.stream().filter(Verdict::isWon).count();
    }

    /** The first seed that does not win, or -1. */
    int firstLostSeed() {
        return IntStream.range(0, jittered.size())
                .filter(seed -> !jittered.get(seed).isWon())
                .findFirst()
                .orElse(-1);
    }
}
