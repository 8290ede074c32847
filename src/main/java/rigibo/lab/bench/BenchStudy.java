package rigibo.lab.bench;

import rigibo.lab.precision.Environment;
import rigibo.lab.report.MeasuredPart;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Makes the runs that are asked for and tells what they found. */
public final class BenchStudy {

    private final Inquiry inquiry;
    private final BenchLab lab;
    private final Environment environment;

    /**
     * A study.
     *
     * @param process main class of the processes that measure; it is told the names of a scene and
     *     of an engine, and a pace in its own words
     * @param environment of the runs; how processes are started is added to its flags
     */
    public BenchStudy(Inquiry inquiry, Class<?> process, Environment environment) {
        this.inquiry = inquiry;
        this.environment = environment;
        lab = new BenchLab(inquiry, process);
    }

    /**
     * Makes the runs that are missing.
     *
     * @param table to which every run is written, if one is
     * @param page whose measured part is written anew, if one is
     * @param tell is told how far the runs are
     * @return what was found, for a terminal
     * @throws IllegalStateException when a run breaks off
     * @throws IOException when something cannot be written
     */
    public List<String> make(Optional<Path> table, Optional<Path> page, Consumer<String> tell)
            throws IOException {
        lab.run(tell);
        Results results = new Results(lab.runs());
        BenchReport report = new BenchReport(inquiry, results);
        if (table.isPresent()) {
            Files.write(table.get(), BenchCsv.lines(results.runs()));
        }
        if (page.isPresent()) {
            MeasuredPart.write(
                    page.get(), report.markdown(environment.withFlags(lab.method()).provenance()));
        }
        return report.text();
    }
}
