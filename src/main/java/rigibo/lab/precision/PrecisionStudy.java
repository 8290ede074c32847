package rigibo.lab.precision;

import rigibo.lab.problem.Problem;
import rigibo.lab.problem.Problems;
import rigibo.lab.report.MeasuredPart;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Measures what accuracy costs in time and writes tables, figures and a page. */
public final class PrecisionStudy {

    private PrecisionStudy() {}

    /**
     * Makes the runs that are missing and writes everything into the inquiry's directory.
     *
     * @param environment of the runs; how processes are started is added to its flags
     * @param page whose measured part is written anew, if there is one
     * @param tell is told how far the runs are
     * @return the main sentences of what was found, a line each
     * @throws IllegalStateException when a run breaks off
     * @throws IOException when something cannot be written
     */
    public static List<String> make(
            Inquiry inquiry, Environment environment, Optional<Path> page, Consumer<String> tell)
            throws IOException {
        PrecisionLab lab = new PrecisionLab(inquiry);
        lab.run(tell);
        List<Problem> problems = inquiry.problems().stream().map(Problems::numbered).toList();
        PrecisionReport report =
                new PrecisionReport(
                        lab.points(),
                        problems,
                        new MoreFigures(inquiry, lab.kept(), tell).sections(),
                        environment.withFlags(lab.method()));
        report.write(inquiry.out());
        if (page.isPresent()) {
            MeasuredPart.write(page.get(), report.markdown());
        }
        return report.sentences();
    }
}
