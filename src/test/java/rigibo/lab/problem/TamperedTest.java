package rigibo.lab.problem;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;

/** A run in which something is wrong does not pass for a right one. */
@Execution(ExecutionMode.CONCURRENT)
class TamperedTest {

    /** The least is some error in proportion to one in a hundred; R7 squares its. */
    @ParameterizedTest
    @CsvSource({
        "R1, 1e-3",
        "R2, 1e-3",
        "R4, 1e-3",
        "R5, 1e-3",
        "R6, 1e-3",
        "R7, 1e-5",
        "R8, 1e-3",
        "R9, 1e-3",
        "R10, 1e-3",
        "R13, 1e-3",
        "R18, 1e-3",
        "R19, 1e-3"
    })
    void onePerCentTooMuchIsAnError(String id, double least) {
        assertThat(errors(id, 1.01).main()).isGreaterThan(least);
        assertThat(errors(id, 1).main()).isLessThan(least);
    }

    /** An engine that presses bodies into each other shows overlap. */
    @ParameterizedTest
    @CsvSource({"R11, 4e-3", "R12, 2"})
    void onePerCentTooLittleIsAnOverlap(String id, double least) {
        assertThat(errors(id, 0.99).main()).isGreaterThan(least);
        assertThat(errors(id, 1).main()).isLessThan(least);
    }

    private static Errors errors(String id, double factor) {
        Problem problem =
                Problems.all().stream()
                        .filter(one -> one.id().equals(id))
                        .findFirst()
                        .orElseThrow();
        Engine engine = new Exaggerating(factor);
        Setting exact = engine.settings().get(3);
        try (Bench bench = Bench.counting(engine, exact)) {
            return problem.set(bench).run();
        }
    }
}
