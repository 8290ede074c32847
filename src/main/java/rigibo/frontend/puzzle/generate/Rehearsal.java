package rigibo.frontend.puzzle.generate;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Plays a planned order of clicks like a patient player, to find the times of a solution. */
final class Rehearsal {

    /** Moment of the first click, steps. */
    private static final int BEGIN = Steps.of(1);

    /** Longest wait for rest after a click, steps. */
    private static final int PATIENCE = Steps.of(5);

    /** Clicks come at whole multiples of this, steps, so that files hold short numbers. */
    private static final int GRID = Steps.of(0.5);

    private Rehearsal() {}

    /** The clicks with their times; empty if one of them is refused. */
    static Optional<Solution> solution(Level level, List<String> targets) {
        PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
        List<Click> clicks = new ArrayList<>();
        int ready = BEGIN;
        for (String target : targets) {
            waitFor(game, ready);
            if (game.act(target) != ClickResult.DONE) {
                return Optional.empty();
            }
            clicks.add(new Click(Steps.seconds(game.steps()), target));
            ready = game.steps() + Steps.of(level.limits().cooldown());
        }
        return Optional.of(new Solution(clicks));
    }

    /** Plays on until the cooldown is over and all bodies are at rest. */
    private static void waitFor(PuzzleGame game, int ready) {
        int latest = ready + PATIENCE;
        while (game.outcome() == Outcome.RUNNING && !isTime(game, ready, latest)) {
            game.step();
        }
    }

    private static boolean isTime(PuzzleGame game, int ready, int latest) {
        boolean isCalm = game.stillSteps() > 0 || game.steps() >= latest;
        return game.steps() >= ready && isCalm && game.steps() % GRID == 0;
    }
}
