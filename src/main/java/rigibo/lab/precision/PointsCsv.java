package rigibo.lab.precision;

import rigibo.lab.child.Fields;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Timing;
import rigibo.lab.report.Csv;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The points as two CSV files, which share their first three columns as keys. */
final class PointsCsv {

    private static final Object[] RESULTS = {
        "problem",
        "engine",
        "setting",
        "line",
        "at",
        "step_s",
        "error",
        "further_errors",
        "failure",
        "steps",
        "simulated_s",
        "pairs",
        "contacts",
        "impacts",
        "evaluations",
        "rows"
    };

    private static final Object[] TIMING = {
        "problem",
        "engine",
        "setting",
        "line",
        "at",
        "step_s",
        "repeats",
        "cpu_us_per_step",
        "cpu_low_us",
        "cpu_high_us",
        "wall_us_per_step",
        "bytes_per_step",
        "cpu_s_per_simulated_s"
    };

    private PointsCsv() {}

    /** The results of all runs, which are the same on every machine. */
    static List<String> results(List<Point> points) {
        List<String> lines = new ArrayList<>(List.of(Csv.line(RESULTS)));
        points.forEach(point -> lines.add(Csv.line(withKeys(point, result(point)))));
        return lines;
    }

    /** The times of the runs that were timed. */
    static List<String> timing(List<Point> points) {
        List<String> lines = new ArrayList<>(List.of(Csv.line(TIMING)));
        for (Point point : points) {
            point.timing().ifPresent(took -> lines.add(Csv.line(withKeys(point, of(took, point)))));
        }
        return lines;
    }

    private static Object[] withKeys(Point point, Stream<Object> values) {
        Setting setting = point.setting();
        Stream<Object> keys =
                Stream.of(
                        point.problem(),
                        point.engine(),
                        setting.name(),
                        setting.line(),
                        setting.at(),
                        setting.step());
        return Stream.concat(keys, values).toArray();
    }

    private static Stream<Object> result(Point point) {
        Stream<Object> told =
                Stream.of(
                        point.errors().hasFailed() ? "" : point.errors().main(),
                        further(point.errors().others()),
                        point.errors().failure(),
                        point.steps(),
                        point.simulated());
        return Stream.concat(told, Fields.of(point.work()));
    }

    private static String further(Map<String, Double> errors) {
        return errors.entrySet().stream()
                .map(error -> error.getKey() + "=" + error.getValue())
                .collect(Collectors.joining("; "));
    }

    private static Stream<Object> of(Timing took, Point point) {
        return Stream.concat(Fields.of(took), Stream.of(point.cost()));
    }
}
