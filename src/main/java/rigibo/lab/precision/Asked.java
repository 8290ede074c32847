package rigibo.lab.precision;

import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.problem.Problem;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** A problem with all points that were measured for it. */
final class Asked {

    private final Problem problem;
    private final List<Point> points;
    private final Front front;

    Asked(Problem problem, List<Point> all) {
        this.problem = problem;
        points = all.stream().filter(point -> point.problem().equals(problem.id())).toList();
        front = new Front(ours().filter(Asked::isAtUsualStep).toList());
    }

    /** Groups points by problem. */
    static List<Asked> of(List<Problem> problems, List<Point> points) {
        return problems.stream()
                .map(problem -> new Asked(problem, points))
                .filter(asked -> !asked.points.isEmpty())
                .toList();
    }

    Problem problem() {
        return problem;
    }

    List<Point> points() {
        return points;
    }

    private static boolean isAtUsualStep(Point point) {
        return point.setting().step() == Setting.USUAL_STEP;
    }

    private Stream<Point> ours() {
        return points.stream().filter(point -> point.engine().equals(RigiBoEngine.NAME));
    }

    /**
     * The front of our own knobs. They belong to an accuracy, so the points are those at the game's
     * time step.
     */
    Front front() {
        return front;
    }

    /** Our points along a line, in the order of the report. */
    List<Point> along(Line line) {
        return ours().filter(point -> point.setting().line() == line).toList();
    }

    /** The lines of our engine that have points, except the presets. */
    List<Line> lines() {
        return Arrays.stream(Line.values())
                .filter(line -> line != Line.PRESETS && !along(line).isEmpty())
                .toList();
    }

    List<Point> presets() {
        return along(Line.PRESETS);
    }

    Optional<Point> game() {
        return presets().stream()
                .filter(point -> point.setting().name().equals("GAME"))
                .findFirst();
    }

    /** The names of the engines that are not ours. */
    List<String> peers() {
        return points.stream()
                .map(Point::engine)
                .filter(engine -> !engine.equals(RigiBoEngine.NAME))
                .distinct()
                .toList();
    }

    /** The points of an engine, the default setting first. */
    List<Point> of(String engine) {
        return points.stream().filter(point -> point.engine().equals(engine)).toList();
    }

    List<Point> failed() {
        return points.stream().filter(point -> point.errors().hasFailed()).toList();
    }
}
