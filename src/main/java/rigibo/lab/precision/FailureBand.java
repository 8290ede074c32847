package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.plot.Anchor;
import rigibo.lab.plot.Letters;
import rigibo.lab.plot.Mark;
import rigibo.lab.plot.Palette;
import rigibo.lab.plot.Picture;
import rigibo.lab.plot.Scale;
import rigibo.lab.plot.Spot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A band above a plot for the runs that failed and so have no error: a row for each line, with a
 * cross at the cost of each run.
 */
final class FailureBand {

    private static final int SIZE = 13;
    private static final double LINE = 17;
    private static final double CROSSES = 16;
    private static final double CROSS = 4.5;

    private record Row(String color, List<String> words, List<Point> points) {}

    private final List<Row> rows = new ArrayList<>();

    FailureBand(Asked asked, double width) {
        Map<String, List<Point>> groups = new LinkedHashMap<>();
        for (Point point : asked.failed()) {
            groups.computeIfAbsent(group(point), name -> new ArrayList<>()).add(point);
        }
        groups.forEach(
                (name, points) ->
                        rows.add(
                                new Row(
                                        look(asked, points.get(0)).color(),
                                        Letters.lines(words(name, points), SIZE, width),
                                        points)));
    }

    private static Look look(Asked asked, Point point) {
        return isPeer(point)
                ? Look.peer(asked.peers().indexOf(point.engine()))
                : Look.of(point.setting().line());
    }

    private static boolean isPeer(Point point) {
        return !point.engine().equals(RigiBoEngine.NAME);
    }

    private static String group(Point point) {
        Line line = point.setting().line();
        return isPeer(point) ? point.engine() : line == Line.PRESETS ? "" : line.words();
    }

    private static String words(String group, List<Point> points) {
        String names =
                points.stream().map(point -> name(group, point)).collect(Collectors.joining(", "));
        return "failed: " + (group.isEmpty() ? names : group + " (" + names + ")");
    }

    /** Without what the group says already. */
    private static String name(String group, Point point) {
        String name = point.setting().name();
        String rest = name.startsWith(group) ? name.substring(group.length()) : name;
        String value = rest.replaceFirst("^[, ]+", "");
        return point.timing().isPresent() ? value : value + ", not timed";
    }

    double height() {
        return rows.stream().mapToDouble(row -> row.words().size() * LINE + CROSSES).sum();
    }

    /** Draws the band from a height downwards. */
    void draw(Picture picture, Scale across, double top) {
        double y = top;
        for (Row row : rows) {
            for (String words : row.words()) {
                y += LINE;
                String color = Palette.forLetters(row.color());
                picture.text(across.start() + 2, y - 3, Anchor.START, SIZE, color, words);
            }
            for (Point point : row.points()) {
                if (point.timing().isPresent()) {
                    Spot at = new Spot(across.at(point.cost()), y + CROSSES / 2 - 1);
                    Mark.cross(picture, at, CROSS, row.color());
                }
            }
            y += CROSSES;
        }
        if (!rows.isEmpty()) {
            picture.line(across.start(), y, across.end(), y, 1, Palette.GRID);
        }
    }
}
