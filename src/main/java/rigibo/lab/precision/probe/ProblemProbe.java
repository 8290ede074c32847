package rigibo.lab.precision.probe;

import rigibo.lab.child.Work;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.Setting;
import rigibo.lab.problem.Bench;
import rigibo.lab.problem.Errors;
import rigibo.lab.problem.Problem;
import rigibo.lab.problem.Problems;
import rigibo.lab.problem.Trial;

import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The main class of a process that runs an engine at a problem. It computes the errors of one
 * setting after the other and then times all of them in turns.
 */
public final class ProblemProbe {

    /** The beginning of the lines that hold findings, in the order of the settings. */
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
     * Prints errors and times.
     *
     * @param arguments id of the problem, name of the engine, patience, and names of settings
     */
    public static void main(String[] arguments) {
        ProblemProbe probe =
                new ProblemProbe(
                        Problems.numbered(arguments[0]),
                        Engines.named(arguments[1]),
                        Patience.parse(arguments[2]));
        List<Setting> settings =
                Arrays.stream(arguments)
                        .skip(FIRST_SETTING)
                        .map(name -> Engines.setting(probe.engine, name))
                        .toList();
        probe.find(settings).forEach(found -> System.out.println(MARK + found.line()));
    }

    private Collection<Finding> find(List<Setting> settings) {
        Map<Setting, Finding> found = new LinkedHashMap<>();
        settings.forEach(setting -> found.put(setting, count(setting)));
        List<Setting> ran = settings.stream().filter(one -> found.get(one).hasRun()).toList();
        boolean isTimedAnew = !patience.equals(Patience.NONE) && !isOneRun();
        if (isTimedAnew && !ran.isEmpty()) {
            new Stopwatch(patience, problem, engine)
                    .time(ran)
                    .forEach((one, took) -> found.put(one, found.get(one).with(took)));
        }
        return found.values();
    }

    private boolean isOneRun() {
        return patience.equals(Patience.ONE_RUN);
    }

    private Finding count(Setting setting) {
        try (Bench bench = Bench.counting(engine, setting)) {
            Trial trial = problem.set(bench);
            Errors errors = trial.run();
            Optional<Timing> took =
                    isOneRun() ? Optional.of(Timing.of(bench.tally())) : Optional.empty();
            return new Finding(errors, bench.steps(), bench.work(), took);
        } catch (UnsupportedOperationException missing) {
            return broken("has no " + missing.getMessage());
        } catch (RuntimeException | AssertionError broken) {
            // An exception of another engine is its result and must not end the laboratory.
            return broken("broke off: " + broken);
        }
    }

    private static Finding broken(String why) {
        return new Finding(Errors.failed(why), 0, Work.NONE, Optional.empty());
    }
}
