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

    private final Inquiry inquiry;
    private final Environment environment;
    private final Consumer<String> tell;

    /**
     * A study.
     *
     * @param environment of the runs; how processes are started is added to its flags
     * @param tell is told how far the runs are
     */
    public PrecisionStudy(Inquiry inquiry, Environment environment, Consumer<String> tell) {
        this.inquiry = inquiry;
        this.environment = environment;
        this.tell = tell;
    }

    /**
     * Makes the runs that are missing and writes everything into the inquiry's directory.
     *
     * @param page whose measured part is written anew, if one is
     * @return the main sentences of what was found, a line each
     * @throws IllegalStateException when a run breaks off
     * @throws IOException when something cannot be written
     */
    public List<String> make(Optional<Path> page) throws IOException {
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
