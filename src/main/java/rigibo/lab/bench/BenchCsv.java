package rigibo.lab.bench;

import rigibo.lab.child.Fields;
import rigibo.lab.child.Work;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.report.Csv;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** The runs as comma-separated values. */
final class BenchCsv {

    private static final Object[] HEAD = {
        "scene",
        "engine",
        "round",
        "steps",
        "median_ns",
        "p99_ns",
        "bytes_per_step",
        "deepest_overlap_m",
        "height_kept",
        "energy_kept",
        "pairs",
        "contacts",
        "impacts",
        "evaluations",
        "rows"
    };

    private BenchCsv() {}

    /** A head and a line for each scene, engine and round. */
    static List<String> lines(List<Run> runs) {
        Stream<String> lines = runs.stream().map(BenchCsv::line);
        return Stream.concat(Stream.of(Csv.line(HEAD)), lines).toList();
    }

    private static String line(Run run) {
        Object[] cells = Fields.of(run).toArray();
        if (!run.engine().equals(RigiBoEngine.NAME)) {
            // Other engines do not report their work: their cells are empty, not 0.
            int told = cells.length - (int) Fields.of(Work.NONE).count();
            Arrays.fill(cells, told, cells.length, "");
        }
        return Csv.line(cells);
    }
}
