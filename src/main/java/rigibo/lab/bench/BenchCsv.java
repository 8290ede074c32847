package rigibo.lab.bench;

import rigibo.lab.bench.probe.Sample;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.report.Csv;

import java.util.List;
import java.util.stream.Stream;

/** Every run as a line of values. */
final class BenchCsv {

    private static final List<String> KEYS = List.of("scene", "engine", "round");

    private BenchCsv() {}

    /** A head and a line for each scene, engine and round. */
    static List<String> lines(List<Run> runs) {
        Stream<String> head =
                Stream.of(Csv.line(Stream.concat(KEYS.stream(), Sample.FIELDS.stream()).toArray()));
        return Stream.concat(head, runs.stream().map(BenchCsv::line)).toList();
    }

    private static String line(Run run) {
        Stream<Object> keys = Stream.of(run.scene(), run.engine(), run.round());
        return Csv.line(Stream.concat(keys, values(run)).toArray());
    }

    /** No work is told by other engines: that is no 0. */
    private static Stream<Object> values(Run run) {
        List<Object> fields = run.sample().fields();
        if (run.engine().equals(RigiBoEngine.NAME)) {
            return fields.stream();
        }
        int told = fields.size() - Sample.WORK_FIELDS;
        Stream<Object> untold = Stream.generate(() -> "");
        return Stream.concat(fields.subList(0, told).stream(), untold.limit(Sample.WORK_FIELDS));
    }
}
