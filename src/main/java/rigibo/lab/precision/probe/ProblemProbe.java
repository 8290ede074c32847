package rigibo.lab.precision.probe;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.Work;
import rigibo.lab.problem.Bench;
import rigibo.lab.problem.Errors;
import rigibo.lab.problem.Problem;
import rigibo.lab.problem.Problems;
import rigibo.lab.problem.Trial;

import java.util.List;
import java.util.Optional;

/** The process: puts an engine to a problem, at one setting after the other. */
public final class ProblemProbe {

    /** What the lines begin with that hold a finding, in the order of the settings. */
    public static final String MARK = "finding ";

    private static final int FIRST_SETTING = 3;

    private final Problem problem;
    private final Engine engine;
    private final Patience patience;

    private ProblemProbe(Problem problem, Engine engine, Patience patience) {
        this.problem = problem;
        this.engine = engine;
        this.patience = patience;
    }

    /**
     * Finds errors and times.
     *
     * @param arguments id of the problem, name of the engine, patience, and names of settings
     */
    public static void main(String[] arguments) {
        ProblemProbe probe =
                new ProblemProbe(
                        Problems.numbered(arguments[0]),
                        Engines.named(arguments[1]),
                        Patience.parse(arguments[2]));
        for (String name : List.of(arguments).subList(FIRST_SETTING, arguments.length)) {
            System.out.println(MARK + probe.find(Engines.setting(probe.engine, name)).line());
        }
    }

    private Finding find(Setting setting) {
        try (Bench bench = Bench.counting(engine, setting)) {
            Trial trial = problem.set(bench);
            long begun = System.nanoTime();
            Errors errors = trial.run();
            return new Finding(errors, bench.steps(), bench.work(), time(setting, begun));
        } catch (UnsupportedOperationException missing) {
            return broken("has no " + missing.getMessage());
        } catch (RuntimeException | AssertionError broken) {
            // What another engine throws is its result, and not the laboratory's end.
            return broken("broke off: " + broken);
        }
    }

    private Optional<Timing> time(Setting setting, long warmSince) {
        if (patience.equals(Patience.NONE)) {
            return Optional.empty();
        }
        return Optional.of(
                new Stopwatch(patience)
                        .time(problem, warmSince, () -> Bench.timed(engine, setting)));
    }

    private static Finding broken(String why) {
        return new Finding(Errors.failed(why), 0, Work.NONE, Optional.empty());
    }
}
