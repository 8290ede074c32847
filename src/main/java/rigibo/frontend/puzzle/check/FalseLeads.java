package rigibo.frontend.puzzle.check;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Ball;
import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Loss;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Finds clicks that look right and lose. These are first clicks that other games win by, made too
 * early, and clicks that bring a ball nearer to the platform. They are also clicks after which
 * every ball lies where it lay, but no click wins any more, which players cannot see; a solution
 * that lacks one click, of which each is right; and orders of par clicks that bring a ball nearer
 * and do not win.
 */
final class FalseLeads {

    private static final int MOMENT = Steps.of(1);

    /** Distance by which a ball must come nearer to count as progress for a player, m. */
    private static final double PROGRESS = 0.5;

    /** Distance by which a ball may move and still lie where it lay, m: half of its radius. */
    private static final double UNMOVED = 0.15;

    private final Level level;
    private final Games games;
    private final Losses losses;

    /** Which games count as lost. */
    enum Losses {
        /** Games in which a ball rolls off the platform or leaves the world. */
        OF_THE_BALL,
        /** Also games that go on although no further click wins; each takes a search. */
        AND_DEAD_ENDS
    }

    FalseLeads(Level level, Games games, Losses losses) {
        this.level = level;
        this.games = games;
        this.losses = losses;
    }

    /**
     * Finds first clicks that mislead, at the game's own accuracy.
     *
     * @param winning targets of the clicks of games that are won
     * @return their ids, in the level's order
     */
    List<String> first(Set<String> winning) {
        List<String> all = level.clickables().stream().map(Clickable::id).toList();
        return games.each(all)
                .filter(id -> misleads(List.of(new Act(MOMENT, id)), winning.contains(id)))
                .toList();
    }

    /** Finds clicks of a solution without which all its other clicks mislead; returns their ids. */
    List<String> forgotten(Solution solution) {
        List<Act> clicks = Replay.of(level, solution, Accuracy.GAME).acts();
        return games.each(clicks)
                .filter(left -> clicks.size() > 1 && misleads(without(clicks, left), false))
                .map(Act::target)
                .toList();
    }

    /** Finds an order of clicks that brings a ball nearer and loses, among some lost games. */
    Optional<List<Act>> order(List<List<Act>> lost) {
        return games.each(lost).filter(clicks -> misleads(clicks, false)).findFirst();
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
        boolean looksRight = areOfWinning || nearest < begin - PROGRESS;
        return looksRight && isBallLost(trial.game())
                || (looksRight || areUnmoved(trial.game())) && isDeadEnd(trial, clicks);
    }

    private boolean areUnmoved(PuzzleGame game) {
        List<Ball> balls = level.balls();
        return IntStream.range(0, balls.size())
                .allMatch(i -> moved(game.balls().get(i), balls.get(i)) < UNMOVED);
    }

    private static double moved(RigidBody body, Ball ball) {
        return Length.hypot(body.x() - ball.x(), body.y() - ball.y());
    }

    private static boolean isBallLost(PuzzleGame game) {
        return game.loss()
                .filter(loss -> loss == Loss.ROLLED_OFF || loss == Loss.LEFT_THE_WORLD)
                .isPresent();
    }

    private boolean isDeadEnd(Trial trial, List<Act> clicks) {
        if (losses == Losses.OF_THE_BALL || !trial.isUnsolved()) {
            return false;
        }
        boolean isAllClicked = trial.game().outcome() == Outcome.LOST;
        OrderSearch search = new OrderSearch(level, games);
        return isAllClicked || !search.winsAfter(clicks, trial.game().steps());
    }

    /** Distance from the platform's middle to the nearest ball, m. */
    private static double distance(PuzzleGame game) {
        RigidBody platform = game.platform();
        return game.balls().stream()
                .mapToDouble(ball -> Length.hypot(ball.x() - platform.x(), ball.y() - platform.y()))
                .min()
                .orElseThrow();
    }
}
