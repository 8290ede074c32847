package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Whether a stored solution needs all of its clicks: no part of it wins at the same times. */
final class NeededClicks {

    /** Of longer solutions the parts are too many; only those that lack one click are played. */
    private static final int LONGEST = 6;

    private NeededClicks() {}

    /** The first part of a solution that wins alone, in words. */
    static Optional<String> winner(Level level, Solution solution, List<Preset> presets) {
        return parts(solution).parallelStream()
                .flatMap(part -> presets.stream().map(preset -> new Part(part, preset)))
                .filter(part -> part.wins(level))
                .findFirst()
                .map(Part::words);
    }

    private record Part(Solution clicks, Preset preset) {

        boolean wins(Level level) {
            return Trial.play(level, Replay.of(level, clicks, preset.accuracy())).isWon();
        }

        String words() {
            return clicks.clicks().stream()
                    .map(Click::body)
                    .collect(Collectors.joining("\", \"", "at " + preset + " \"", "\" is enough"));
        }
    }

    private static List<Solution> parts(Solution solution) {
        int count = solution.clicks().size();
        return IntStream.range(1, (1 << Math.min(count, 30)) - 1)
                .filter(mask -> count <= LONGEST || Integer.bitCount(mask) == count - 1)
                .mapToObj(mask -> part(solution, mask))
                .toList();
    }

    /** The clicks whose bits are set. */
    private static Solution part(Solution solution, int mask) {
        List<Click> clicks = new ArrayList<>();
        for (int i = 0; i < solution.clicks().size(); i++) {
            if ((mask >> i & 1) == 1) {
                clicks.add(solution.clicks().get(i));
            }
        }
        return new Solution(clicks);
    }
}
