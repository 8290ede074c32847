package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Deletion;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** Tries every level body that a click can delete, alone. */
final class SingleClicks {

    /**
     * When to click, s. A level at rest gives the same game at any of them, so a few prove it; what
     * moves by itself is E160's to find.
     */
    private static final double[] MOMENTS = {0, 1, 2.5};

    private SingleClicks() {}

    static int count(Level level) {
        return all(level).size();
    }

    /** The first single click that wins. */
    static Optional<Deletion> winner(Level level, Accuracy accuracy) {
        long hash = level.hash();
        return all(level).parallelStream()
                .filter(
                        click ->
                                Trial.play(level, new Replay(hash, List.of(click), accuracy))
                                        .isWon())
                .findFirst();
    }

    private static List<Deletion> all(Level level) {
        return level.bodies().stream()
                .filter(LevelBody::deletable)
                .flatMap(
                        body ->
                                IntStream.range(0, MOMENTS.length)
                                        .mapToObj(
                                                i -> new Deletion(Steps.of(MOMENTS[i]), body.id())))
                .toList();
    }
}
