package rigibo.lab.precision;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Patience;
import rigibo.lab.problem.Problem;
import rigibo.lab.problem.Problems;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The order for a run of the laboratory.
 *
 * @param problems ids
 * @param extent how much of each problem is run
 * @param seed of the order of processes, so that other work of the machine does not always hit the
 *     same settings
 * @param out directory of everything written
 */
public record Inquiry(List<String> problems, Extent extent, long seed, Path out) {

    /** The names that may be asked for. */
    public static List<String> problemIds() {
        return Problems.all().stream().map(Problem::id).toList();
    }

    /** The exams, by problem and engine. */
    List<Exam> exams(List<Engine> engines) {
        List<Exam> exams = new ArrayList<>();
        for (String id : problems) {
            Problem problem = Problems.numbered(id);
            for (Engine engine : engines) {
                if (problem.isForAll() || engine.name().equals(RigiBoEngine.NAME)) {
                    exams.addAll(exams(problem, engine));
                }
            }
        }
        return exams;
    }

    /**
     * One exam, whose settings take turns. For a long problem every setting is its own exam: it is
     * timed only once, and an interrupted report loses one setting rather than all.
     */
    private List<Exam> exams(Problem problem, Engine engine) {
        List<Setting> settings =
                engine.settings().stream()
                        .filter(setting -> isAsked(problem, setting.line()))
                        .toList();
        Stream<List<Setting>> parts =
                problem.isLong() ? settings.stream().map(List::of) : Stream.of(settings);
        Patience patience = extent.patience(problem);
        return parts.map(part -> new Exam(problem.id(), engine, part, patience)).toList();
    }

    private boolean isAsked(Problem problem, Line line) {
        boolean isAlways = line == Line.PRESETS || line == Line.PEERS;
        return extent.asks(line) && (isAlways || problem.lines().contains(line));
    }
}
