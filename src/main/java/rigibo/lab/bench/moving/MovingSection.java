package rigibo.lab.bench.moving;

import rigibo.lab.bench.probe.StepTimes;
import rigibo.lab.report.Amount;
import rigibo.lab.report.Report.Passage;
import rigibo.lab.report.Table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** The part of the report about one moving scene, a row for each contestant. */
final class MovingSection {

    /** The aim for the mean step of the fastest other engine, as a multiple of ours. */
    private static final double FASTER = 2;

    /**
     * The aims for our 99th percentile, as a multiple of that of the fastest other engine and of a
     * typical step of ours.
     */
    private static final double P99_BY_PEER = 0.5;

    private static final double P99_BY_EVEN_STEP = 3;

    private static final List<String> HEAD =
            List.of(
                    "engine",
                    "mean",
                    "p99",
                    "max",
                    "mean in times of GAME",
                    "deepest overlap in widths",
                    "at the end",
                    "energy gained",
                    "joints off by",
                    "at rest after");

    private final String title;
    private final Map<Contestant, Course> courses;
    private final int steps;

    /** A section about the courses of a scene, with a number of steps of each. */
    MovingSection(String title, Map<Contestant, Course> courses, int steps) {
        this.title = title;
        this.courses = courses;
        this.steps = Math.max(1, Math.min(steps, moving() + 1));
    }

    /** The last step in which a body moves in our engine or in the fastest other one. */
    private int moving() {
        return courses.entrySet().stream()
                .filter(e -> e.getKey().equals(Contestant.OURS) || e.getKey().isFastestPeer())
                .mapToInt(e -> e.getValue().lastMoving())
                .max()
                .orElse(Integer.MAX_VALUE - 1);
    }

    Passage passage() {
        String told = title + ", " + steps + " steps";
        return new Passage(told, told, "", table(), sentences());
    }

    Table table() {
        return new Table(
                HEAD, courses.entrySet().stream().map(e -> row(e.getKey(), e.getValue())).toList());
    }

    private List<String> row(Contestant contestant, Course course) {
        StepTimes times = course.times(steps);
        return List.of(
                contestant.words(),
                Amount.time(times.mean()),
                Amount.time(times.p99()),
                Amount.time(times.max()),
                ours().map(our -> Amount.digits(times.mean() / our.times(steps).mean())).orElse(""),
                widths(course.deepest()),
                widths(course.left()),
                Double.isNaN(course.gain()) ? "driven" : Amount.scientific(course.gain()),
                course.jointError() == 0 ? "" : Amount.scientific(course.jointError()) + " m",
                rest(course));
    }

    private static String widths(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }

    private static String rest(Course course) {
        boolean rests = course.lastMoving() < course.nanos().length - 1;
        return rests
                ? String.format(Locale.ROOT, "%.1f s", (course.lastMoving() + 1) / 60.0)
                : "not yet";
    }

    private Optional<Course> ours() {
        return Optional.ofNullable(courses.get(Contestant.OURS));
    }

    /**
     * Says whether our engine is as fast and as even as is aimed for; empty if it or the fastest
     * other engine was not run.
     */
    List<String> sentences() {
        Optional<Course> peer =
                courses.entrySet().stream()
                        .filter(entry -> entry.getKey().isFastestPeer())
                        .map(Map.Entry::getValue)
                        .findFirst();
        if (ours().isEmpty() || peer.isEmpty()) {
            return List.of();
        }
        StepTimes our = ours().get().times(steps);
        StepTimes their = peer.get().times(steps);
        double even = ours().get().busyTimes(steps).median();
        List<String> sentences = new ArrayList<>();
        sentences.add(
                "gdx-box2d's mean is "
                        + verdict(their.mean() / our.mean(), FASTER)
                        + "; our p99 is "
                        + bound(our.p99() / their.p99(), P99_BY_PEER)
                        + " of its p99, our max "
                        + bound(our.max() / their.max(), 1)
                        + " of its max; our p99 is "
                        + bound(our.p99() / even, P99_BY_EVEN_STEP)
                        + " of a step with at least half of the most contacts.");
        return sentences;
    }

    private static String verdict(double value, double least) {
        return Amount.digits(value) + " × ours (≥ " + (int) least + met(value >= least);
    }

    private static String bound(double value, double most) {
        return Amount.digits(value) + " × (≤ " + Amount.digits(most) + met(value <= most);
    }

    private static String met(boolean isMet) {
        return isMet ? ": met)" : ": not met)";
    }
}
