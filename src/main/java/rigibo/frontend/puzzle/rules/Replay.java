package rigibo.frontend.puzzle.rules;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;

import java.util.List;

/**
 * Everything that decides a game, so that it can be replayed to the same bits.
 *
 * @param levelHash hash of its level
 * @param deletions in the order of their steps
 * @param accuracy of the simulation
 */
public record Replay(long levelHash, List<Deletion> deletions, Accuracy accuracy) {

    public Replay {
        deletions = List.copyOf(deletions);
    }

    /** A stored solution as a replay. */
    public static Replay of(Level level, Solution solution, Accuracy accuracy) {
        List<Deletion> deletions =
                solution.clicks().stream()
                        .map(click -> new Deletion(Steps.of(click.seconds()), click.body()))
                        .toList();
        return new Replay(level.hash(), deletions, accuracy);
    }

    /** The deletions as a level file states them. */
    public Solution solution() {
        return new Solution(
                deletions.stream()
                        .map(deletion -> new Click(Steps.seconds(deletion.step()), deletion.body()))
                        .toList());
    }

    /** Returns this replay without its last deletion. */
    public Replay withoutLast() {
        return new Replay(
                levelHash, deletions.subList(0, Math.max(0, deletions.size() - 1)), accuracy);
    }
}
