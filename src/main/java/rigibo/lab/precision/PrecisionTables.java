package rigibo.lab.precision;

import rigibo.lab.report.Amount;
import rigibo.lab.report.Table;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

/** Tables of errors, each with the time of a step beside it, a row for each problem. */
final class PrecisionTables {

    private static final double NANOS_PER_MICRO = 1e3;

    private final List<Asked> all;

    PrecisionTables(List<Asked> all) {
        this.all = all;
    }

    /** The table of our presets. */
    Table presets() {
        List<String> head = new ArrayList<>(List.of("problem"));
        all.get(0).presets().forEach(preset -> head.add(preset.setting().name()));
        return new Table(head, rows(Asked::presets));
    }

    /** The table of {@code GAME} and other engines. */
    Table engines() {
        List<String> head = new ArrayList<>(List.of("problem", "GAME"));
        others(all.get(0))
                .forEach(other -> head.add(other.engine() + " " + other.setting().name()));
        return new Table(
                head, rows(asked -> Stream.concat(asked.game().stream(), others(asked)).toList()));
    }

    private static Stream<Point> others(Asked asked) {
        return asked.peers().stream().flatMap(peer -> asked.of(peer).stream());
    }

    /** Whether there are points to show. */
    boolean hasEngines() {
        return !all.isEmpty() && others(all.get(0)).findAny().isPresent();
    }

    private List<List<String>> rows(Function<Asked, List<Point>> points) {
        int columns = points.apply(all.get(0)).size();
        return all.stream()
                .filter(asked -> points.apply(asked).size() == columns)
                .map(asked -> row(asked, points.apply(asked)))
                .toList();
    }

    private static List<String> row(Asked asked, List<Point> points) {
        List<String> cells = new ArrayList<>();
        cells.add(asked.problem().id() + " " + asked.problem().title());
        points.forEach(point -> cells.add(cell(point)));
        return cells;
    }

    private static String cell(Point point) {
        String error =
                point.errors().hasFailed() ? "fails" : Amount.scientific(point.errors().main());
        return point.timing()
                .map(took -> error + Table.BESIDE + Amount.time(took.cpu() * NANOS_PER_MICRO))
                .orElse(error);
    }
}
