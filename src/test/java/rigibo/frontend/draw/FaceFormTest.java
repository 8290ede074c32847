package rigibo.frontend.draw;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Polygon;

class FaceFormTest {

    /** The white of an eye and its rim, in units of a face. */
    private static final double EYE = 0.235;

    /** Pixels of a metre in a window of 720 × 800. */
    private static final double SCALE = 80;

    private static FaceForm form(double width, double height) {
        return FaceForm.of(FigureTest.of(Polygon.box(width, height)));
    }

    @Test
    void onlyThinBoxesHaveAnotherFace() {
        assertThat(form(0.5, 0.7)).isEqualTo(FaceForm.USUAL);
        assertThat(form(1, 1)).isEqualTo(FaceForm.USUAL);
        assertThat(form(2.2, 0.7)).isEqualTo(FaceForm.USUAL);
        assertThat(form(2.4, 0.2)).isEqualTo(FaceForm.LOW);
        assertThat(form(1.2, 0.3)).isEqualTo(FaceForm.LOW);
        assertThat(form(0.22, 1.2)).isEqualTo(FaceForm.NARROW);
        Polygon roof = Polygon.of(-1.6, 0, 1.6, 0, 1.6, 0.12, -1.6, 0.4);
        assertThat(FaceForm.of(FigureTest.of(roof))).as("no box").isEqualTo(FaceForm.USUAL);
    }

    /** Thinner than these is no RigiBo box of the game. */
    @ParameterizedTest
    @CsvSource({"0.8,0.2", "1.2,0.3", "2.4,0.2", "5.9,0.3", "0.22,1.2", "0.3,1", "0.22,0.6"})
    void eyesOnThinBoxesAreSevenPixelsWideAndInside(double width, double height) {
        Figure figure = FigureTest.of(Polygon.box(width, height));
        FaceForm form = FaceForm.of(figure);
        double unit = form.unit(figure);
        assertThat(2 * EYE * unit * SCALE).isGreaterThanOrEqualTo(7);
        assertThat((form.eyeX + EYE) * unit).isLessThan(width / 2);
        assertThat((form.eyeY + EYE) * unit).isLessThan(height / 2);
    }
}
