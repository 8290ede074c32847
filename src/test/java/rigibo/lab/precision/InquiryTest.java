package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Patience;
import rigibo.lab.problem.Problem;
import rigibo.lab.problem.Problems;

import java.nio.file.Path;
import java.util.List;

/** How much is asked of an engine. */
class InquiryTest {

    private static final Engine ENGINE = new RigiBoEngine();

    private static List<Exam> exams(Problem problem, Extent extent) {
        return new Inquiry(List.of(problem.id()), extent, 1, Path.of(".")).exams(List.of(ENGINE));
    }

    /** Every knob of a crowd would take hours. Only rain is asked what passes and substeps buy. */
    @Test
    void longProblemsAreAskedOfPresetsAndFewKnobsAndOnce() {
        List<Problem> problems = Problems.all().stream().filter(Problem::isLong).toList();
        assertThat(problems).extracting(Problem::id).containsExactly("R14", "R15", "R16", "R20");
        for (Problem problem : problems) {
            List<Exam> exams = exams(problem, Extent.FULL);
            assertThat(exams).extracting(Exam::patience).containsOnly(Patience.ONE_RUN);
            assertThat(exams).extracting(exam -> exam.settings().size()).containsOnly(1);
            assertThat(exams.subList(0, 4))
                    .extracting(exam -> exam.settings().get(0).name())
                    .containsExactly("DRAFT", "GAME", "FINE", "EXACT");
            assertThat(exams.subList(4, exams.size()))
                    .extracting(exam -> exam.settings().get(0).line())
                    .containsAll(problem.lines())
                    .isSubsetOf(problem.lines());
        }
    }

    @Test
    void settingsOfOtherProblemsTakeTurnsInOneExam() {
        for (Problem problem : Problems.all()) {
            if (!problem.isLong()) {
                List<Exam> exams = exams(problem, Extent.FULL);
                assertThat(exams).hasSize(1);
                assertThat(exams.get(0).settings())
                        .extracting(Setting::line)
                        .containsAll(problem.lines())
                        .contains(Line.PRESETS);
            }
        }
    }

    @Test
    void quicklyPresetsAreAskedOnly() {
        assertThat(exams(Problems.numbered("R3"), Extent.QUICK).get(0).settings())
                .extracting(Setting::line)
                .containsOnly(Line.PRESETS);
    }
}
