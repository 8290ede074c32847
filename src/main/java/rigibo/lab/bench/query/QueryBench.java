package rigibo.lab.bench.query;

import rigibo.lab.bench.moving.Contestant;
import rigibo.lab.child.Fields;
import rigibo.lab.child.MeasuringJava;
import rigibo.lab.child.Progress;
import rigibo.lab.report.Report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Times queries in every contestant, each in its own process.
 *
 * @param contestants in the order of the report
 * @param runs by which everything is timed
 */
public record QueryBench(List<Contestant> contestants, int runs) {

    private static final int HEAP_MEGABYTES = 512;

    /** Describes how processes are run. */
    public String method() {
        return MeasuringJava.onLastCore(HEAP_MEGABYTES).words();
    }

    /**
     * Times all contestants.
     *
     * @param tell is told how far it is
     * @throws IllegalStateException when a process breaks off, with what it said
     */
    public Report run(Consumer<String> tell) {
        MeasuringJava java = MeasuringJava.onLastCore(HEAP_MEGABYTES);
        Progress progress = new Progress(contestants.size(), tell);
        Map<Contestant, Answers> found = new LinkedHashMap<>();
        for (Contestant contestant : contestants) {
            List<String> told = List.of(contestant.engine(), contestant.setting(), "" + runs);
            String line = java.run(QueryProbe.class, told, QueryProbe.MARK);
            found.put(contestant, Fields.parse(Answers.class, line));
            progress.done();
        }
        return new QueryReport(found).report();
    }
}
