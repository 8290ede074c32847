package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.MassProperties;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

import java.util.Random;
import java.util.stream.Stream;

/** Mass, centre and inertia of every kind of shape beside points thrown at it. */
class MonteCarloMassTest {

    private static final int POINTS = 400_000;

    /** Standard deviations that a mean of random points may be off by: 1 in 10⁶ is. */
    private static final double SIGMAS = 5;

    private static final double DENSITY = 3;

    static Stream<Shape> shapes() {
        return Stream.of(
                new Circle(0.7),
                new Capsule(0.8, 0.3),
                Polygon.box(1.5, 0.4),
                Polygon.regular(5, 0.9),
                Polygon.of(0, 0, 2, 0, 0.3, 1.1),
                Polygon.box(1, 0.6).rounded(0.25),
                Polygon.of(0, 0, 2, 0, 0.3, 1.1).rounded(0.2),
                Compound.of(
                        Part.of(Polygon.box(1, 0.2)),
                        Part.of(Polygon.box(0.2, 0.8)).at(-0.4, 0.5),
                        Part.of(new Circle(0.15)).at(0.4, 0.25)),
                Compound.ofOutline(0, 0, 2, 0, 2, 0.5, 0.5, 0.5, 0.5, 1.5, 0, 1.5));
    }

    /**
     * A point of the square of side 2R hits with the share p = area/(4R²). What is weighed is the
     * mean of 1, x, y and x² + y² over all points, 0 for those that miss; each such mean of N is
     * off by the deviation of one over √N.
     */
    @ParameterizedTest
    @MethodSource("shapes")
    void isWhatPointsThrownAtItWeigh(Shape shape) {
        Random random = new Random(11);
        double reach = shape.boundingRadius();
        double square = DENSITY * 4 * reach * reach;
        Placement here = Placement.at(0, 0);
        double[] sum = new double[4];
        double[] squares = new double[4];
        for (int i = 0; i < POINTS; i++) {
            double x = (2 * random.nextDouble() - 1) * reach;
            double y = (2 * random.nextDouble() - 1) * reach;
            if (Geometry.holds(shape, here, x, y)) {
                double[] weighed = {1, x, y, x * x + y * y};
                for (int k = 0; k < 4; k++) {
                    sum[k] += weighed[k];
                    squares[k] += weighed[k] * weighed[k];
                }
            }
        }
        MassProperties exact = shape.massProperties(DENSITY);
        // The centre of mass is the origin of the frame in which points are asked about.
        double[] expected = {exact.mass(), 0, 0, exact.inertia()};
        for (int k = 0; k < 4; k++) {
            double mean = sum[k] / POINTS;
            double deviation = Math.sqrt((squares[k] / POINTS - mean * mean) / POINTS);
            assertThat(square * mean)
                    .as("moment %d of %s", k, shape)
                    .isEqualTo(expected[k], within(SIGMAS * square * deviation));
        }
    }
}
