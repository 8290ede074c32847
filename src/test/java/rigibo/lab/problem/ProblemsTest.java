package rigibo.lab.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;

import java.util.Arrays;
import java.util.List;

/** What holds for every reference problem. */
class ProblemsTest {

    private static final Engine ENGINE = new RigiBoEngine();

    /** Errors differ in their last digits by how sums are rounded. */
    private static final double ROUND_OFF = 1e-12;

    private static List<Problem> problems() {
        return Problems.all();
    }

    @ParameterizedTest
    @MethodSource("problems")
    void slowerPresetIsNeverLessAccurate(Problem problem) {
        double[] error = presets().stream().mapToDouble(to -> error(problem, to)).toArray();
        for (int i = 1; i < error.length; i++) {
            assertThat(error[i])
                    .as("%s errs at the presets by %s", problem.id(), Arrays.toString(error))
                    .isLessThanOrEqualTo(error[i - 1] * (1 + ROUND_OFF));
        }
    }

    /** As far as it counts. */
    private static double error(Problem problem, Setting preset) {
        Errors errors = errors(problem, preset);
        assertThat(errors.failure()).as(problem.id() + " at " + preset.name()).isEmpty();
        return Math.max(errors.main(), problem.equalBelow());
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
