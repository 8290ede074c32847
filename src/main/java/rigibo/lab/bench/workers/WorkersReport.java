package rigibo.lab.bench.workers;

import rigibo.lab.bench.probe.StepTimes;
import rigibo.lab.report.Amount;
import rigibo.lab.report.Report;
import rigibo.lab.report.Table;

import java.util.List;
import java.util.Locale;

/** Reports what more workers gain. */
final class WorkersReport {

    private final List<WorkersCourse> courses;
    private final Crew comparedWith;

    WorkersReport(List<WorkersCourse> courses, Crew comparedWith) {
        this.courses = courses;
        this.comparedWith = comparedWith;
    }

    Report table() {
        return Report.of(
                new Table(
                        List.of(
                                "scene",
                                "workers",
                                "mean",
                                "p99",
                                "most",
                                "times as fast",
                                "efficiency",
                                "processor time",
                                "steps that share",
                                "meetings"),
                        courses.stream().map(this::row).toList()),
                List.of());
    }

    private List<String> row(WorkersCourse course) {
        double first =
                courses.stream()
                        .filter(other -> other.scene().equals(course.scene()))
                        .filter(other -> other.crew().equals(comparedWith))
                        .findFirst()
                        .orElseThrow()
                        .wall()
                        .mean();
        StepTimes wall = course.wall();
        double gain = first / wall.mean();
        return List.of(
                course.scene().name(),
                course.crew().words(),
                Amount.time(wall.mean()),
                Amount.time(wall.p99()),
                Amount.time(wall.max()),
                Amount.digits(gain),
                percent(gain * comparedWith.workers() / course.crew().workers()),
                Amount.time(course.processor().mean()),
                percent(course.shared()),
                String.format(Locale.ROOT, "%.0f", course.meetings()));
    }

    private static String percent(double share) {
        return String.format(Locale.ROOT, "%.0f %%", 100 * share);
    }
}
