package rigibo.frontend.puzzle.check;

import rigibo.frontend.document.Fault;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Star;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.Optional;

/**
 * Proves that a level's secret star can be earned, and that the solution which is shown does not
 * earn it. Unlike a solution the star may take skill: it must be earned as the file states it, and
 * in most games with small displacements.
 */
final class StarTrials {

    private final List<SolutionTrials.Game> games;
    private final boolean isShown;

    StarTrials(Level level, Star star, List<Preset> presets, Games played) {
        games = SolutionTrials.of(level, star.solution(), presets, played).games();
        isShown =
                level.solutions().stream()
                        .limit(1)
                        .anyMatch(shown -> isEarned(level, shown, presets, played));
    }

    private static boolean isEarned(
            Level level, Solution shown, List<Preset> presets, Games played) {
        return SolutionTrials.asStated(level, shown, presets, played)
                .anyMatch(SolutionTrials.Game::hasStar);
    }

    private long earned() {
        return games.stream().filter(SolutionTrials.Game::hasStar).count();
    }

    /** The findings in words. */
    String words() {
        return "earned in " + earned() + " of " + games.size() + " games";
    }

    /** The fault of the star, if it has one. */
    Optional<Fault> fault() {
        Optional<Fault> missed =
                games.stream()
                        .filter(game -> game.isAsStated() && !game.hasStar())
                        .map(
                                game ->
                                        Fault.of(
                                                "E154.missed",
                                                "E154 its solution does not earn it %s",
                                                game))
                        .findFirst();
        if (missed.isPresent()) {
            return missed;
        }
        if (2 * earned() <= games.size()) {
            return Optional.of(
                    Fault.of("E154.luck", "E154 needs luck: %s", words())
                            .naming(earned(), games.size()));
        }
        return isShown
                ? Optional.of(
                        Fault.of(
                                "E154.shown",
                                "E154 is no secret: /solutions/0, which is shown, earns it"))
                : Optional.empty();
    }
}
