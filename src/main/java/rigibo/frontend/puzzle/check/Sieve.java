package rigibo.frontend.puzzle.check;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Length;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Click;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongConsumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Keeps a level made by chance only if {@code levels check --accuracy GAME} would pass it and it is
 * a puzzle: luck does not solve it, and something misleads. Tests come in the order of their cost,
 * and the first that fails ends it. Uses the calling thread alone.
 */
public final class Sieve {

    /** Least and greatest number of clicks of a solution. */
    private static final int LEAST_PAR = 2;

    private static final int MOST_PAR = 5;

    /** Largest share of orders that may win. */
    private static final double MOST_WINS = 0.3;

    /** Delay of each click that must not lose the game, s. */
    private static final double LATE = 0.25;

    private static final double CENTIMETRES = 100;

    private static final List<Preset> PRESETS = List.of(Preset.GAME);

    private final Games games;

    /**
     * A sieve for any number of levels.
     *
     * @param told the number of games after each
     */
    public Sieve(LongConsumer told) {
        games = new Games(Games.Cores.ONE, told);
    }

    /**
     * Returns the findings on a level with one solution, whose clicks are its par; empty if it is
     * no puzzle.
     *
     * @throws java.util.concurrent.CancellationException when the thread was interrupted
     */
    public Optional<Figures> figures(Level level) {
        Solution solution = level.solutions().get(0);
        int par = solution.clicks().size();
        if (par < LEAST_PAR || par > MOST_PAR || !isSound(level, solution)) {
            return Optional.empty();
        }
        OrderSearch.Found found = new OrderSearch(level, games).search(MOST_WINS);
        boolean isPuzzle = found.shorter().isEmpty() && found.wins().value() <= MOST_WINS;
        return isPuzzle ? Optional.of(figures(level, solution, found)) : Optional.empty();
    }

    private Figures figures(Level level, Solution solution, OrderSearch.Found found) {
        Trial winning = new Trial(level, Replay.of(level, solution, Accuracy.GAME));
        double travel = travel(winning);
        FalseLeads leads = leads(level);
        return new Figures(
                solution.clicks().size(),
                level.clickables().size(),
                found.wins().games(),
                found.wins().wins(),
                leads.first(found.winning()),
                leads.forgotten(solution),
                winning.game().steps(),
                (int) Math.round(travel * CENTIMETRES));
    }

    /** Plays a game to its end; returns the length of the first ball's path, m. */
    private double travel(Trial trial) {
        RigidBody ball = trial.game().balls().get(0);
        double travel = 0;
        while (!trial.isOver()) {
            double x = ball.x();
            double y = ball.y();
            trial.step();
            travel += Length.hypot(ball.x() - x, ball.y() - y);
        }
        games.count(trial.game().steps());
        return travel;
    }

    private boolean isSound(Level level, Solution solution) {
        return wins(level, solution)
                && misleads(level, solution)
                && wins(level, late(solution))
                && RestCheck.isAtRest(level, PRESETS)
                && NeededClicks.winner(level, solution, PRESETS, games).isEmpty()
                && new SingleClicks(level, PRESETS, games).winner().isEmpty()
                && SolutionTrials.winAll(level, solution, PRESETS, games);
    }

    private boolean wins(Level level, Solution solution) {
        return games.play(level, Replay.of(level, solution, Accuracy.GAME)).isWon();
    }

    private boolean misleads(Level level, Solution solution) {
        FalseLeads leads = leads(level);
        return !leads.forgotten(solution).isEmpty() || !leads.first(targets(solution)).isEmpty();
    }

    /** Dead ends are left out: counting them would give every seed another level. */
    private FalseLeads leads(Level level) {
        return new FalseLeads(level, games, FalseLeads.Losses.OF_THE_BALL);
    }

    private static Set<String> targets(Solution solution) {
        return solution.clicks().stream().map(Click::target).collect(Collectors.toSet());
    }

    /** A solution with each click delayed, relative to the one before it. */
    private static Solution late(Solution solution) {
        List<Click> clicks = solution.clicks();
        return new Solution(
                IntStream.range(0, clicks.size())
                        .mapToObj(i -> late(clicks.get(i), (i + 1) * LATE))
                        .toList());
    }

    private static Click late(Click click, double seconds) {
        return new Click(click.seconds() + seconds, click.target());
    }

    /** Games played for all levels so far. */
    public long games() {
        return games.played();
    }

    /** Steps of 1/60 s in these games. */
    public long steps() {
        return games.steps();
    }
}
