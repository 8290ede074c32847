package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

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
     * Delay at which a click must still win, steps: a player who sees what to do is slower than the
     * file.
     */
    private static final int LATEST = Steps.of(0.25);

    /**
     * That delay for a level made by chance, steps. {@link Sieve} tests a larger one on its own;
     * another delay here would give every seed another level.
     */
    private static final int LATEST_OF_MADE = Steps.of(0.1);

    /**
     * One game.
     *
     * @param preset accuracy of the simulation
     * @param seed of its jitter
     * @param verdict the outcome
     */
    record Game(Preset preset, int seed, Verdict verdict) {

        boolean isWon() {
            return verdict.isWon();
        }

        boolean hasStar() {
            return verdict.hasStar();
        }

        boolean isAsStated() {
            return seed == Jitter.STATED;
        }

        @Override
        public String toString() {
            return (isAsStated() ? "" : "with seed " + seed + " ")
                    + "at "
                    + preset
                    + ": "
                    + verdict;
        }
    }

    static SolutionTrials of(Level level, Solution solution, List<Preset> presets, Games games) {
        return new SolutionTrials(all(level, solution, presets, LATEST, games).toList());
    }

    /** Whether every game is won; plays none after the first that is lost. */
    static boolean winAll(Level level, Solution solution, List<Preset> presets, Games games) {
        return all(level, solution, presets, LATEST_OF_MADE, games).allMatch(Game::isWon);
    }

    /** The games as the file states them, one for each preset. */
    static Stream<Game> asStated(
            Level level, Solution solution, List<Preset> presets, Games games) {
        return presets.stream()
                .map(preset -> play(level, solution, preset, Jitter.STATED, LATEST, games));
    }

    private static Stream<Game> all(
            Level level, Solution solution, List<Preset> presets, int latest, Games games) {
        int count = (SEEDS + 1) * presets.size();
        return games.each(IntStream.range(0, count).boxed().toList())
                .map(
                        i -> {
                            Preset preset = presets.get(i % presets.size());
                            return play(level, solution, preset, i / presets.size(), latest, games);
                        });
    }

    private static Game play(
            Level level, Solution solution, Preset preset, int seed, int latest, Games games) {
        Level moved = Jitter.of(level, seed);
        return new Game(
                preset,
                seed,
                games.play(moved, Jitter.of(moved, solution, preset.accuracy(), seed, latest)));
    }

    int wins() {
        return (int) games.stream().filter(Game::isWon).count();
    }

    Optional<Game> firstLost() {
        return games.stream().filter(game -> !game.isWon()).findFirst();
    }
}
