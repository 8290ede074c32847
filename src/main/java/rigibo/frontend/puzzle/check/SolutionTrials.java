package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A stored solution played on every preset asked for, as the file states it and with bodies
 * slightly displaced and clicks slightly late.
 *
 * @param games all games played, those as stated first
 */
record SolutionTrials(List<Game> games) {

    /** Varied games per preset. */
    private static final int SEEDS = 40;

    /**
     * One game.
     *
     * @param preset how exactly it was simulated
     * @param seed of its jitter
     * @param verdict how it went
     */
    record Game(Preset preset, int seed, Verdict verdict) {

        boolean isWon() {
            return verdict.isWon();
        }

        @Override
        public String toString() {
            return (seed == Jitter.STATED ? "" : "with seed " + seed + " ")
                    + "at "
                    + preset
                    + ": "
                    + verdict;
        }
    }

    static SolutionTrials of(Level level, Solution solution, List<Preset> presets) {
        int count = (SEEDS + 1) * presets.size();
        return new SolutionTrials(
                IntStream.range(0, count)
                        .parallel()
                        .mapToObj(
                                i ->
                                        play(
                                                level,
                                                solution,
                                                presets.get(i % presets.size()),
                                                i / presets.size()))
                        .toList());
    }

    private static Game play(Level level, Solution solution, Preset preset, int seed) {
        Level moved = Jitter.of(level, seed);
        return new Game(
                preset,
                seed,
                Trial.play(moved, Jitter.of(moved, solution, preset.accuracy(), seed)));
    }

    int wins() {
        return (int) games.stream().filter(Game::isWon).count();
    }

    Optional<Game> firstLost() {
        return games.stream().filter(game -> !game.isWon()).findFirst();
    }
}
