package rigibo.frontend.puzzle.replay;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.List;

/**
 * A run of a level that can be replayed and compared.
 *
 * @param level the level played
 * @param replay the clicks
 * @param checkpoints states of the run, the last one at its end
 */
public record Recording(Level level, Replay replay, List<Checkpoint> checkpoints) {

    /**
     * Longest recording, an hour in steps. A longer wait is no play, and its proof would take too
     * long.
     */
    static final int MOST_STEPS = Steps.of(3600);

    public Recording {
        checkpoints = List.copyOf(checkpoints);
        if (checkpoints.isEmpty()) {
            throw new IllegalArgumentException("Recording.checkpoints must not be empty");
        }
    }

    /** A game up to the present step. */
    public static Recording of(PuzzleGame game) {
        return new Recording(game.level(), game.replay(), game.checkpoints());
    }

    /**
     * A stored solution, played with the present simulation until the level is won or lost.
     *
     * @throws IllegalArgumentException when nothing is decided within a number of steps
     */
    public static Recording of(Level level, Solution solution, Accuracy accuracy, int mostSteps) {
        Playback playback = new Playback(level, Replay.of(level, solution, accuracy));
        while (playback.game().outcome() == Outcome.RUNNING) {
            if (playback.game().steps() >= mostSteps) {
                throw new IllegalArgumentException(
                        level.id() + " is neither won nor lost within " + mostSteps + " steps");
            }
            playback.step();
        }
        return of(playback.game());
    }

    /** Steps from the start to the end. */
    public int steps() {
        return checkpoints.get(checkpoints.size() - 1).step();
    }

    /** Number of clicks. */
    public int clicks() {
        return replay.acts().size();
    }

    /** Whether it took fewer clicks than another run of the level, or as many in less time. */
    boolean isBetterThan(Recording other) {
        return clicks() != other.clicks() ? clicks() < other.clicks() : steps() < other.steps();
    }
}
