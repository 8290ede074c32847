package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.stream.Stream;

/** Points that make no convex polygon, and what the caller is told. */
class PolygonRefusalTest {

    static Stream<Arguments> refused() {
        double nan = Double.NaN;
        double infinite = Double.POSITIVE_INFINITY;
        return Stream.of(
                Arguments.of("no points", new double[0], "3 to 256 corners"),
                Arguments.of("two corners", new double[] {0, 0, 1, 0}, "3 to 256 corners"),
                Arguments.of("half a corner", new double[] {0, 0, 1, 0, 1, 1, 0}, "x, y pairs"),
                Arguments.of("NaN", new double[] {0, 0, 1, nan, 1, 1}, "corner 1"),
                Arguments.of("infinity", new double[] {0, 0, 1, 0, infinite, 1}, "corner 2"),
                Arguments.of("clockwise", new double[] {0, 0, 0, 1, 1, 1, 1, 0}, "reflex"),
                Arguments.of("reflex", new double[] {0, 0, 2, 0, 1, 0.5, 2, 2}, "corner 2"),
                Arguments.of("repeated", new double[] {0, 0, 1, 0, 1, 0, 1, 1}, "repeated"),
                Arguments.of("collinear", new double[] {0, 0, 1, 0, 2, 0, 1, 1}, "on the line"),
                Arguments.of("all on a line", new double[] {0, 0, 1, 1, 2, 2}, "Polygon.of"),
                Arguments.of("all in one place", new double[] {1, 1, 1, 1, 1, 1}, "repeated"),
                Arguments.of("too small to have an area", tiny(), "Polygon.of"));
    }

    private static double[] tiny() {
        return new double[] {0, 0, 1e-200, 0, 0, 1e-200};
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("refused")
    void pointsThatMakeNoPolygonAreRefused(String what, double[] xy, String message) {
        assertThatThrownBy(() -> Polygon.of(xy))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }

    /** A pentagram turns left at every corner, but goes round twice. */
    @Test
    void starIsRefused() {
        double[] xy = new double[10];
        for (int i = 0; i < 5; i++) {
            xy[2 * i] = Math.cos(4 * Math.PI * i / 5);
            xy[2 * i + 1] = Math.sin(4 * Math.PI * i / 5);
        }
        assertThatThrownBy(() -> Polygon.of(xy)).hasMessageContaining("2 times");
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 2, 257})
    void regularPolygonsHaveThreeToManyCorners(int corners) {
        assertThatThrownBy(() -> Polygon.regular(corners, 1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("3 to 256");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void sidesThatMakeNoBoxAreRefused(double side) {
        assertThatThrownBy(() -> Polygon.box(side, 1)).hasMessageContaining("width");
        assertThatThrownBy(() -> Polygon.box(1, side)).hasMessageContaining("height");
        assertThatThrownBy(() -> Polygon.regular(5, side)).hasMessageContaining("radius");
    }

    @Test
    void sliversOfOneToTenThousandAreFine() {
        assertThat(Polygon.box(1, 1e-4).area()).isEqualTo(1e-4);
        assertThat(Polygon.of(0, 0, 1, 0, 1, 1e-4).corners()).isEqualTo(3);
    }
}
