package rigibo.frontend.puzzle.check;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Loss;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.List;
import java.util.Set;

/**
 * Finds first clicks that look right and lose the ball: those that other games win by, made too
 * early, and those that bring a ball nearer to the platform on its way out of the world.
 */
final class FalseLeads {

    private static final int MOMENT = Steps.of(1);

    /** How much nearer a ball must come for a player to take it for progress, m. */
    private static final double PROGRESS = 0.5;

    private final Level level;
    private final Games games;

    FalseLeads(Level level, Games games) {
        this.level = level;
        this.games = games;
    }

    /**
     * Finds them at the game's own accuracy.
     *
     * @param winning what is clicked in games that are won
     * @return their ids, in the level's order
     */
    List<String> of(Set<String> winning) {
        List<String> all = level.clickables().stream().map(Clickable::id).toList();
        return games.each(all).filter(first -> misleads(first, winning.contains(first))).toList();
    }

    private boolean misleads(String first, boolean isOfWinning) {
        Replay click = new Replay(level.hash(), List.of(new Act(MOMENT, first)), Accuracy.GAME);
        Trial trial = new Trial(level, click);
        double begin = distance(trial.game());
        double nearest = begin;
        while (!trial.isOver()) {
            trial.step();
            nearest = Math.min(nearest, distance(trial.game()));
        }
        games.count(trial.game().steps());
        return isBallLost(trial.game()) && (isOfWinning || nearest < begin - PROGRESS);
    }

    private static boolean isBallLost(PuzzleGame game) {
        return game.loss()
                .filter(loss -> loss == Loss.ROLLED_OFF || loss == Loss.LEFT_THE_WORLD)
                .isPresent();
    }

    /** Distance of the nearest ball from the platform's middle, m. */
    private static double distance(PuzzleGame game) {
        RigidBody platform = game.platform();
        return game.balls().stream()
                .mapToDouble(ball -> Math.hypot(ball.x() - platform.x(), ball.y() - platform.y()))
                .min()
                .orElseThrow();
    }
}
