package rigibo.lab.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;

import java.util.List;
import java.util.Set;

/** Properties of every reference problem. */
@Execution(ExecutionMode.CONCURRENT)
class ProblemsTest {

    private static final Engine ENGINE = new RigiBoEngine();

    /** Problems whose errors at the faster presets exceed the limit of EXACT. */
    private static final Set<String> TOLD_APART = Set.of("R3", "R4", "R13", "R17", "R19");

    /** Those that do not take minutes; small ones of the crowds are in CrowdProblemTest. */
    private static List<Problem> problems() {
        return Problems.all().stream().filter(one -> !one.isLong()).toList();
    }

    /**
     * Most problems leave nothing to choose: every preset solves them as well as EXACT promises.
     */
    @ParameterizedTest
    @MethodSource("solvedByAll")
    void everyPresetKeepsWhatExactPromises(Problem problem) {
        assertThat(errors(problem))
                .as(problem.id())
                .allSatisfy(error -> assertThat(error).isLessThanOrEqualTo(problem.equalBelow()));
    }

    @ParameterizedTest
    @MethodSource("toldApart")
    void slowerPresetIsMoreAccurateWhereErrorsCount(Problem problem) {
        List<Double> errors = errors(problem);
        assertThat(errors.get(0)).as(problem.id()).isGreaterThan(problem.equalBelow());
        for (int i = 1; i < errors.size(); i++) {
            double most = Math.max(errors.get(i - 1), problem.equalBelow());
            assertThat(errors.get(i))
                    .as("%s errs at the presets by %s", problem.id(), errors)
                    .isLessThan(most);
        }
    }

    private static List<Problem> toldApart() {
        return problems().stream().filter(one -> TOLD_APART.contains(one.id())).toList();
    }

    private static List<Problem> solvedByAll() {
        return problems().stream().filter(one -> !TOLD_APART.contains(one.id())).toList();
    }

    /** At every preset, from the fastest to the most exact. */
    private static List<Double> errors(Problem problem) {
        return presets().stream().map(preset -> error(problem, preset)).toList();
    }

    private static double error(Problem problem, Setting preset) {
        Errors errors = errors(problem, preset);
        assertThat(errors.failure()).as(problem.id() + " at " + preset.name()).isEmpty();
        return errors.main();
    }

    @Test
    void numbersAreInOrderAndDiffer() {
        assertThat(Problems.all()).extracting(Problem::id).doesNotHaveDuplicates();
    }

    private static List<Setting> presets() {
        return ENGINE.settings().stream()
                .filter(setting -> setting.line() == Line.PRESETS)
                .toList();
    }

    private static Errors errors(Problem problem, Setting setting) {
        try (Bench bench = Bench.counting(ENGINE, setting)) {
            return problem.set(bench).run();
        }
    }
}
