package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Clickable;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Act;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.atomic.LongAdder;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Searches orders and times of clicks, with one click more in each round, up to par.
 *
 * <p>It covers every order of the targets. Each is clicked at the end of the cooldown, then every
 * half second as long as something moves; at rest the moment of a click does not matter, so one
 * moment stands for all later ones. A finished game is not searched further. A round with more
 * games than {@link #MOST_GAMES} is sampled, with a fixed seed.
 */
final class OrderSearch {

    /** Time between the moments tried while something moves, steps. */
    private static final int PERIOD = Steps.of(0.5);

    /** Most games of a round: about three seconds of two cores. */
    private static final int MOST_GAMES = 300;

    private static final int SEED = 1;

    private final Level level;
    private final Games games;
    private final Branches branches;
    private final int cooldown;

    OrderSearch(Level level, Games games) {
        this.level = level;
        this.games = games;
        branches = new Branches(level, Accuracy.GAME, games);
        cooldown = Steps.of(level.limits().cooldown());
    }

    /**
     * The findings of the search.
     *
     * @param wins number of won games of par clicks
     * @param fewer number of won games of fewer clicks; the search ends with the first
     * @param winning targets of the clicks of won games
     * @param lost the clicks of games of par clicks that are not won
     * @param shorter clicks that win with less than par, if any
     */
    record Found(
            Share wins,
            Share fewer,
            Set<String> winning,
            List<List<Act>> lost,
            Optional<List<Act>> shorter) {}

    /** A line and how it ended. */
    private record Course(Line line, Verdict verdict) {

        List<Act> clicks() {
            return line.clicks();
        }

        boolean isWon() {
            return verdict.isWon();
        }
    }

    Found search() {
        return search(1);
    }

    /**
     * Searches until the level is known to be no puzzle: fewer clicks than par win, or a larger
     * share of all games of par clicks.
     *
     * @param mostWins that share, 0 to 1; with 1 all games are played
     */
    Found search(double mostWins) {
        List<Course> round = List.of(course(branches.line(List.of())));
        boolean isWhole = true;
        int fewer = 0;
        for (int clicks = 1; ; clicks++) {
            List<Branches.Next> all = nexts(round);
            boolean wasWhole = isWhole;
            isWhole &= all.size() <= MOST_GAMES;
            List<Branches.Next> some = sample(all);
            boolean isLast = clicks == level.limits().par();
            double most = isLast || mostWins == 1 ? mostWins : 0;
            round = played(some, (int) (most * some.size()));
            List<Course> won = round.stream().filter(Course::isWon).toList();
            Share wins = new Share(won.size(), round.size(), isWhole);
            if (isLast) {
                Share none = new Share(0, fewer, wasWhole);
                return new Found(wins, none, targets(won), lost(round), Optional.empty());
            }
            fewer += round.size();
            if (!won.isEmpty()) {
                List<Act> first = won.get(0).clicks();
                return new Found(wins, wins, targets(won), List.of(), Optional.of(first));
            }
        }
    }

    /**
     * Whether some game wins with up to par clicks more than those made.
     *
     * @param until step until which a player looks on after them
     */
    boolean winsAfter(List<Act> made, int until) {
        int ready = made.get(made.size() - 1).step() + cooldown;
        List<Branches.Next> all = nexts(branches.line(made), IntStream.of(Math.max(ready, until)));
        for (int more = 0; more < level.limits().par(); more++) {
            List<Branches.Next> some = sample(all);
            List<Course> round = played(some, some.size());
            if (round.stream().anyMatch(Course::isWon)) {
                return true;
            }
            all = nexts(round);
        }
        return false;
    }

    private static List<List<Act>> lost(List<Course> round) {
        return round.stream().filter(course -> !course.isWon()).map(Course::clicks).toList();
    }

    private static Set<String> targets(List<Course> courses) {
        return courses.stream()
                .flatMap(course -> course.clicks().stream())
                .map(Act::target)
                .collect(Collectors.toSet());
    }

    private Course course(Line line) {
        return new Course(line, branches.play(line));
    }

    /**
     * Plays games, none after more wins than {@code mostWins}. One whose click comes to a body that
     * has meanwhile fallen out of the world is dropped.
     */
    private List<Course> played(List<Branches.Next> some, int mostWins) {
        LongAdder wins = new LongAdder();
        return games.each(branches.lines(some))
                .filter(line -> wins.sum() <= mostWins)
                .map(this::course)
                .peek(course -> wins.add(course.isWon() ? 1 : 0))
                .filter(course -> course.verdict.end() != Verdict.End.REFUSED)
                .toList();
    }

    private static List<Branches.Next> sample(List<Branches.Next> all) {
        Collections.shuffle(all, new Random(SEED));
        return all.subList(0, Math.min(all.size(), MOST_GAMES));
    }

    /** The line of each course, and one more click. */
    private List<Branches.Next> nexts(List<Course> round) {
        List<Branches.Next> all = new ArrayList<>();
        round.forEach(course -> all.addAll(nexts(course.line, moments(course))));
        return all;
    }

    private List<Branches.Next> nexts(Line made, IntStream moments) {
        Set<String> clicked = made.clicks().stream().map(Act::target).collect(Collectors.toSet());
        List<String> left =
                level.clickables().stream()
                        .filter(one -> one.verb().repeats() || !clicked.contains(one.id()))
                        .map(Clickable::id)
                        .toList();
        return moments.boxed()
                .flatMap(at -> left.stream().map(id -> new Branches.Next(made, new Act(at, id))))
                .collect(Collectors.toCollection(ArrayList::new));
    }

    /** Steps at which one more click may lead to another game. */
    private IntStream moments(Course course) {
        int ready = course.clicks().isEmpty() ? 0 : course.line.last() + cooldown;
        int last =
                switch (course.verdict.end()) {
                    case WON, REFUSED -> ready - 1;
                    case LOST -> course.verdict.steps() - 1;
                    // The first moment at rest stands for all that follow.
                    case STUCK -> Math.max(ready, course.verdict.still() + PERIOD - 1);
                };
        return IntStream.iterate(ready, at -> at <= last, at -> at + PERIOD);
    }
}
