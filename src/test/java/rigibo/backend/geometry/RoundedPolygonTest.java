package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

class RoundedPolygonTest {

    private static final Polygon WEDGE = Polygon.of(0, 0, 3, 0, 0, 1);

    /** Steiner's formula for what lies within r of a convex polygon: A + P·r + π·r². */
    @Test
    void areaGrowsByPerimeterAndDisc() {
        double perimeter = 3 + 1 + Math.sqrt(10);
        assertThat(WEDGE.rounded(0.2).area())
                .isEqualTo(1.5 + 0.2 * perimeter + Math.PI * 0.04, within(1e-14));
    }

    /**
     * A square of side 2a with a rounding of r is a cross of two rectangles and a disc's quarters,
     * whose centroids lie 4r/3π from the corners' lines.
     */
    @Test
    void inertiaOfARoundedSquare() {
        double a = 0.5;
        double r = 0.25;
        double side = 4 * a * a;
        double strip = 2 * a * r;
        double quarter = Math.PI * r * r / 4;
        double far = a + 4 * r / (3 * Math.PI);
        double ownQuarter =
                quarter * (r * r / 2) - quarter * 2 * Math.pow(4 * r / (3 * Math.PI), 2);
        double truth =
                side * (8 * a * a) / 12
                        + 4 * (strip * (4 * a * a + r * r) / 12 + strip * Math.pow(a + r / 2, 2))
                        + 4 * (ownQuarter + quarter * 2 * far * far);

        MassProperties plate = Polygon.box(2 * a, 2 * a).rounded(r).massProperties(1);

        assertThat(plate.inertia()).isEqualTo(truth, within(1e-14));
    }

    /** Rounding moves the centroid of what is not symmetric; a sum over points agrees. */
    @Test
    void massOfAWedgeAsByMonteCarlo() {
        Polygon rounded = WEDGE.rounded(0.4);
        Random random = new Random(1);
        int count = 400_000;
        double reach = rounded.boundingRadius();
        double inside = 0;
        double sumX = 0;
        double sumY = 0;
        double polar = 0;
        for (int i = 0; i < count; i++) {
            double x = reach * (2 * random.nextDouble() - 1);
            double y = reach * (2 * random.nextDouble() - 1);
            if (rounded.outline().depth(x, y) >= 0) {
                inside++;
                sumX += x;
                sumY += y;
                polar += x * x + y * y;
            }
        }
        double cell = 4 * reach * reach / count;
        // A share p of n points errs by √(p(1 − p)/n), below 1/(2√n); four times that, and as much
        // of the reach for what is weighed by places.
        double error = 2 / Math.sqrt(count);
        assertThat(inside * cell).isEqualTo(rounded.area(), within(error * 4 * reach * reach));
        assertThat(sumX / inside).isEqualTo(0, within(2 * error * reach));
        assertThat(sumY / inside).isEqualTo(0, within(2 * error * reach));
        assertThat(polar * cell)
                .isEqualTo(
                        rounded.massProperties(1).inertia(),
                        within(error * 4 * Math.pow(reach, 4)));
    }

    @Test
    void outlineGoesRoundTheCorners() {
        Polygon square = Polygon.box(2, 2).rounded(0.5);

        assertThat(square.boundingRadius()).isEqualTo(Math.sqrt(2) + 0.5, within(1e-15));
        assertThat(square.smallestWidth()).isEqualTo(3);
        assertThat(square.outline().depth(1.5, 0)).isEqualTo(0, within(1e-15));
        double corner = 1 + 0.5 * Math.sqrt(0.5);
        assertThat(square.outline().depth(corner, corner)).isEqualTo(0, within(1e-15));
        assertThat(square.outline().depth(0, 0)).isEqualTo(1.5, within(1e-15));
        assertThat(square.isBox()).isFalse();
        assertThat(square.rounded(0).isBox()).isTrue();
    }

    @Test
    void roundedAgainFromTheStatedCornersIsTheSame() {
        Polygon rounded = WEDGE.rounded(0.4);

        assertThat(Polygon.of(rounded.stated()).rounded(rounded.radius())).isEqualTo(rounded);
        assertThat(rounded).isNotEqualTo(WEDGE);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.1, Double.NaN, Double.POSITIVE_INFINITY, 1e7})
    void radiiOutOfRangeAreRefused(double radius) {
        assertThatThrownBy(() -> WEDGE.rounded(radius))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Polygon.rounded radius")
                .hasMessageContaining("" + radius);
    }
}
