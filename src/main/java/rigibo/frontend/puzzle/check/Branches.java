package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Bookmarks;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Plays the lines of a search, and once what they have in common. Played each from the start, they
 * took two thirds of their time for steps before the last click.
 */
final class Branches {

    private final Level level;
    private final Accuracy accuracy;
    private final Games games;

    /** Empty for a level whose games have to be played whole. */
    private final Optional<Bookmarks> bookmarks;

    /**
     * A line and one more click.
     *
     * @param line so far
     * @param act the click
     */
    record Next(Line line, Act act) {}

    Branches(Level level, Accuracy accuracy, Games games) {
        this.level = level;
        this.accuracy = accuracy;
        this.games = games;
        bookmarks = Bookmarks.fit(level) ? Optional.of(new Bookmarks(level)) : Optional.empty();
    }

    /** A line by itself. */
    Line line(List<Act> clicks) {
        Line line = new Line(clicks, Optional.empty());
        return new Line(
                clicks,
                bookmarks.map(
                        all -> begins(all, line, IntStream.of(line.last())).get(line.last())));
    }

    /** The lines with one more click each, in their order. */
    List<Line> lines(List<Next> some) {
        Map<Line, Map<Integer, Bookmarks.Bookmark>> begins =
                bookmarks.map(all -> begins(all, some)).orElse(Map.of());
        return some.stream()
                .map(
                        next ->
                                new Line(
                                        next.line.with(next.act),
                                        Optional.ofNullable(begins.get(next.line))
                                                .map(moments -> moments.get(next.act.step()))))
                .toList();
    }

    private Map<Line, Map<Integer, Bookmarks.Bookmark>> begins(Bookmarks all, List<Next> some) {
        Map<Line, List<Next>> nexts = some.stream().collect(Collectors.groupingBy(Next::line));
        return games.each(List.copyOf(nexts.keySet()))
                .collect(
                        Collectors.toMap(
                                line -> line,
                                line ->
                                        begins(
                                                all,
                                                line,
                                                nexts.get(line).stream()
                                                        .mapToInt(next -> next.act.step()))));
    }

    /** Goes on with a line once, and keeps it at each moment of some. */
    private Map<Integer, Bookmarks.Bookmark> begins(Bookmarks all, Line line, IntStream moments) {
        Playback playback = playback(line);
        Map<Integer, Bookmarks.Bookmark> begins = new HashMap<>();
        moments.sorted()
                .distinct()
                .forEach(
                        moment -> {
                            games.playTo(playback, moment);
                            begins.put(moment, all.at(playback.game()));
                        });
        return begins;
    }

    /** Plays a line to its end. */
    Verdict play(Line line) {
        return games.play(new Trial(playback(line), replay(line)));
    }

    private Playback playback(Line line) {
        return line.begin()
                .map(begin -> new Playback(begin.game(), replay(line)))
                .orElseGet(() -> new Playback(level, replay(line)));
    }

    private Replay replay(Line line) {
        return new Replay(level.hash(), line.clicks(), accuracy);
    }
}
