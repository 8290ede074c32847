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
 * @param acts in the order of their steps
 * @param accuracy of the simulation
 */
public record Replay(long levelHash, List<Act> acts, Accuracy accuracy) {

    public Replay {
        acts = List.copyOf(acts);
    }

    /** A stored solution as a replay. */
    public static Replay of(Level level, Solution solution, Accuracy accuracy) {
        List<Act> acts =
                solution.clicks().stream()
                        .map(click -> new Act(Steps.of(click.seconds()), click.target()))
                        .toList();
        return new Replay(level.hash(), acts, accuracy);
    }

    /** The clicks as a level file states them. */
    public Solution solution() {
        return new Solution(
                acts.stream()
                        .map(act -> new Click(Steps.seconds(act.step()), act.target()))
                        .toList());
    }

    /** Returns this replay without its last click. */
    public Replay withoutLast() {
        return new Replay(levelHash, acts.subList(0, Math.max(0, acts.size() - 1)), accuracy);
    }
}
