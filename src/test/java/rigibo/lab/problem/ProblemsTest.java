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
import java.util.Set;

/** What holds for every reference problem. */
class ProblemsTest {

    private static final Engine ENGINE = new RigiBoEngine();

    /** Errors differ in their last digits by how sums are rounded. */
    private static final double ROUND_OFF = 1e-12;

    /**
     * Where the promise is not kept. {@code SPLIT} knows the moment when a disc touches a wall in
     * closed form; {@code EVENTS} reflect it before the wall, by up to the tolerance. Where nothing
     * but such impacts happens, DRAFT is right to round-off and GAME errs by what it was told to
     * tolerate: 4e-6 of the height of R6, 1.5e-3 of the room of R10, in proportion to the
     * tolerance.
     */
    private static final Set<String> SPLIT_IS_EXACT = Set.of("R6", "R10");

    private static List<Problem> problems() {
        return Problems.all();
    }

    @ParameterizedTest
    @MethodSource("problems")
    void slowerPresetIsNeverLessAccurate(Problem problem) {
        double[] error = presets().stream().mapToDouble(to -> error(problem, to)).toArray();
        int first = SPLIT_IS_EXACT.contains(problem.id()) ? 1 : 0;
        assertThat(first == 1)
                .as("%s is said to be exact where impacts are split: %s", problem.id(), error)
                .isEqualTo(isLess(error[0], error[1]));
        for (int i = first + 1; i < error.length; i++) {
            assertThat(isLess(error[i - 1], error[i]))
                    .as("%s errs at the presets by %s", problem.id(), Arrays.toString(error))
                    .isFalse();
        }
    }

    private static boolean isLess(double one, double other) {
        return one * (1 + ROUND_OFF) < other;
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
