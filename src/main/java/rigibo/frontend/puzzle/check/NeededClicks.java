package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Checks that a stored solution needs all of its clicks: no subset of them wins at the same times.
 */
final class NeededClicks {

    /**
     * Most clicks of a solution whose subsets are all played; of a longer one, only the subsets
     * that lack a single click.
     */
    private static final int LONGEST = 6;

    private NeededClicks() {}

    /** Describes the first subset of a solution that wins alone. */
    static Optional<String> winner(
            Level level, Solution solution, List<Preset> presets, Games games) {
        return games.each(parts(solution))
                .flatMap(part -> presets.stream().map(preset -> new Part(part, preset)))
                .filter(part -> part.wins(level, games))
                .findFirst()
                .map(Part::words);
    }

    private record Part(Solution clicks, Preset preset) {

        boolean wins(Level level, Games games) {
            return games.play(level, Replay.of(level, clicks, preset.accuracy())).isWon();
        }

        String words() {
            return clicks.clicks().stream()
                    .map(Click::target)
                    .collect(Collectors.joining("\", \"", "at " + preset + " \"", "\" is enough"));
        }
    }

    private static List<Solution> parts(Solution solution) {
        List<Click> clicks = solution.clicks();
        return clicks.size() <= LONGEST ? allParts(clicks) : allButOne(clicks);
    }

    /** All subsets but the empty and the full one: bit i of a mask keeps click i. */
    private static List<Solution> allParts(List<Click> clicks) {
        return IntStream.range(1, (1 << clicks.size()) - 1)
                .mapToObj(mask -> kept(clicks, i -> (mask >> i & 1) == 1))
                .toList();
    }

    private static List<Solution> allButOne(List<Click> clicks) {
        return IntStream.range(0, clicks.size())
                .mapToObj(left -> kept(clicks, i -> i != left))
                .toList();
    }

    private static Solution kept(List<Click> clicks, IntPredicate isKept) {
        return new Solution(
                IntStream.range(0, clicks.size()).filter(isKept).mapToObj(clicks::get).toList());
    }
}
