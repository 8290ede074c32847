package rigibo.lab.precision;

import rigibo.lab.problem.Problem;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** What accuracy costs in time, told from the points that were measured. */
final class PrecisionReport {

    private final List<Point> points;
    private final List<Problem> problems;
    private final Environment environment;

    /**
     * A report.
     *
     * @param points in the order the settings are told; of an engine that is not ours the first is
     *     as it comes, the others are finer
     * @param problems whose points are told, in their order; those without points are left out
     */
    PrecisionReport(List<Point> points, List<Problem> problems, Environment environment) {
        this.points = List.copyOf(points);
        this.problems = List.copyOf(problems);
        this.environment = environment;
    }

    /**
     * Writes tables, figures and the page into a directory that exists.
     *
     * @return what was written
     */
    List<Path> write(Path directory) throws IOException {
        return List.of(
                Files.write(directory.resolve("results.csv"), PointsCsv.results(points)),
                Files.write(directory.resolve("timing.csv"), PointsCsv.timing(points)),
                Files.writeString(directory.resolve("env.json"), environment.json()));
    }

    /** The main sentences of what was found, a line each. */
    List<String> sentences() {
        return List.of(problems.size() + " problems, " + points.size() + " points.");
    }

    /** The measured part of a page of Markdown. */
    String markdown() {
        return environment.words() + "\n";
    }
}
