package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.lab.plot.Box;
import rigibo.lab.plot.Drawing;
import rigibo.lab.plot.Seen;

import java.util.List;
import java.util.stream.Stream;

class WorkPrecisionFigureTest {

    private static final List<Asked> ALL = Asked.of(FakePoints.PROBLEMS, FakePoints.all());

    static Stream<Drawing> drawings() {
        return Stream.of(FigureSize.WIDE, FigureSize.NARROW)
                .flatMap(
                        size ->
                                ALL.stream()
                                        .map(
                                                asked ->
                                                        new WorkPrecisionFigure(asked, size)
                                                                .drawing()));
    }

    private static Seen seen(Drawing drawing) {
        Seen seen = new Seen();
        drawing.on(seen);
        return seen;
    }

    private static List<String> words(Asked asked) {
        Drawing drawing = new WorkPrecisionFigure(asked, FigureSize.NARROW).drawing();
        return seen(drawing).texts().stream().map(Seen.Text::words).toList();
    }

    @ParameterizedTest
    @MethodSource("drawings")
    void noTwoTextsOverlapAndNoneIsCutOff(Drawing drawing) {
        Seen seen = seen(drawing);
        Box all = new Box(0, 0, drawing.width(), drawing.height());
        assertThat(seen.overlaps()).isEmpty();
        assertThat(seen.texts()).allSatisfy(text -> assertThat(all.holds(text.box())).isTrue());
    }

    @Test
    void presetsPeersAndLinesAreNamedWithTheirOrder() {
        assertThat(words(ALL.get(0)))
                .contains(
                        "DRAFT",
                        "GAME",
                        "FINE",
                        "EXACT",
                        "dyn4j 6.0.0",
                        "step, by Euler: order 1.0")
                .contains("step, by Verlet", "≤ 10⁻¹³");
    }

    @Test
    void failuresAreNamedAndNotDropped() {
        String all = String.join(" ", words(ALL.get(1)));
        assertThat(all)
                .contains("failed: step, impacts at its end (1/15 s)")
                .contains("failed: dyn4j 6.0.0 (finer, 1/240 s)");
    }
}
