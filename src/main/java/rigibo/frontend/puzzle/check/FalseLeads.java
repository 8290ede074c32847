package rigibo.frontend.puzzle.check;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Loss;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.List;
import java.util.Set;

/**
 * Finds what looks right and loses the ball. First clicks do that other games win by, made too
 * early, and those that bring a ball nearer to the platform on its way out of the world. So does a
 * solution that lacks one click: each of its clicks is right, the ball comes, and is lost.
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
     * Finds first clicks that mislead, at the game's own accuracy.
     *
     * @param winning what is clicked in games that are won
     * @return their ids, in the level's order
     */
    List<String> first(Set<String> winning) {
        List<String> all = level.clickables().stream().map(Clickable::id).toList();
        return games.each(all)
                .filter(id -> misleads(List.of(new Act(MOMENT, id)), winning.contains(id)))
                .toList();
    }

    /** Finds clicks of a solution without which all its others mislead; returns their ids. */
    List<String> forgotten(Solution solution) {
        List<Act> clicks = Replay.of(level, solution, Accuracy.GAME).acts();
        return games.each(clicks)
                .filter(left -> clicks.size() > 1 && misleads(without(clicks, left), false))
                .map(Act::target)
                .toList();
    }

    private static List<Act> without(List<Act> clicks, Act left) {
        return clicks.stream().filter(click -> click != left).toList();
    }

    private boolean misleads(List<Act> clicks, boolean areOfWinning) {
        Trial trial = new Trial(level, new Replay(level.hash(), clicks, Accuracy.GAME));
        double begin = distance(trial.game());
        double nearest = begin;
        while (!trial.isOver()) {
            trial.step();
            nearest = Math.min(nearest, distance(trial.game()));
        }
        games.count(trial.game().steps());
        return isBallLost(trial.game()) && (areOfWinning || nearest < begin - PROGRESS);
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
