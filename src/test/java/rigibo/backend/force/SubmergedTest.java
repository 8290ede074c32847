package rigibo.backend.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

/** The submerged part of a body, compared with closed forms and with sums of strips. */
class SubmergedTest {

    /** Some units in the last place of numbers about 1. */
    private static final double ROUND_OFF = 1e-13;

    /** The error of Simpson's rule over a disc, with a decade to spare. */
    private static final double QUADRATURE = 1e-11;

    /** Sides 3 and 4 at the right angle; its centre of mass is at (1, 4/3) from there. */
    private static final Polygon TRIANGLE = Polygon.of(0, 0, 3, 0, 0, 4);

    private static final Polygon PENTAGON = Polygon.of(0, 0, 2, -1, 3, 1, 1.5, 2.5, -0.5, 1);

    private final Submerged under = new Submerged();

    private void measure(Shape shape, double angle, double level) {
        under.measure(Instants.of(shape, angle), level);
    }

    private void require(double area, double x, double y, double second) {
        assertThat(under.area).as("area").isEqualTo(area, within(ROUND_OFF));
        assertThat(under.centroidX).as("centroid x").isEqualTo(x, within(ROUND_OFF));
        assertThat(under.centroidY).as("centroid y").isEqualTo(y, within(ROUND_OFF));
        assertThat(under.secondMoment).as("second moment").isEqualTo(second, within(ROUND_OFF));
    }

    private void require(Strips strips, double tolerance) {
        assertThat(under.area).as("area").isEqualTo(strips.area, within(tolerance));
        assertThat(under.area * under.centroidX)
                .as("first moment x")
                .isEqualTo(strips.momentX, within(tolerance));
        assertThat(under.area * under.centroidY)
                .as("first moment y")
                .isEqualTo(strips.momentY, within(tolerance));
        assertThat(under.secondMoment)
                .as("second moment")
                .isEqualTo(strips.second, within(tolerance));
    }

    /** Half a disc: πr²/2, its centroid 4r/3π below, and half of the disc's πr⁴/2. */
    @Test
    void halfADisc() {
        measure(new Circle(1), 0, 0);
        require(Math.PI / 2, 0, -4 / (3 * Math.PI), Math.PI / 4);
    }

    /** At half the radius below the centre the half angle is π/3: π/3 − √3/4 of r², and so on. */
    @Test
    void aSegmentOfADiscToHalfItsRadius() {
        measure(new Circle(2), 1, -1);
        double area = 4 * (Math.PI / 3 - Math.sqrt(3) / 4);
        assertThat(under.area).isEqualTo(area, within(ROUND_OFF));
        assertThat(under.area * under.centroidY)
                .isEqualTo(-2.0 / 3 * Math.pow(3, 1.5), within(ROUND_OFF));
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1.2, -1.1, -0.5, -0.01, 0, 0.3, 1.1, 1.2})
    void discsAsTheSumOfStrips(double level) {
        measure(new Circle(1.25), 0, level);
        require(Strips.of(1.25, level), QUADRATURE);
    }

    @ParameterizedTest
    @ValueSource(doubles = {2, 2.5, 100})
    void aWholeDisc(double level) {
        measure(new Circle(2), 0, level);
        require(4 * Math.PI, 0, 0, 8 * Math.PI);
    }

    /** Draught 0.5 of a box of 2 × 1: w·d, its centre at ¾·½ below, A·(w² + d²)/12 + A·y². */
    @Test
    void halfABox() {
        measure(Polygon.box(2, 1), 0, 0);
        require(1, 0, -0.25, (4 + 0.25) / 12 + 0.0625);
    }

    @Test
    void aWholeBox() {
        measure(Polygon.box(2, 1), 0.4, 1.2);
        require(2, 0, 0, 2 * (4 + 1) / 12.0);
    }

    /**
     * The lowest corner of a square that stands on it, to the depth t: a triangle of the base 2t
     * and the height t, t²·(t²/18 + t²/6) about its own centroid, which is t/3 under the level.
     */
    @Test
    void theCornerOfASquareOnItsTip() {
        double t = 0.5;
        double level = t - Math.sqrt(2) / 2;
        measure(Polygon.box(1, 1), Math.PI / 4, level);
        double y = level - t / 3;
        require(t * t, 0, y, t * t * t * t * (1.0 / 18 + 1.0 / 6) + t * t * y * y);
    }

    /**
     * The lower 1 m: of the area 6 the part above is 6·(¾)² = 3.375, similar to the whole; by
     * moments about the right angle x = (6·1 − 3.375·0.75)/2.625, y = (6·4/3 − 3.375·2)/2.625.
     */
    @Test
    void theFootOfATriangle() {
        measure(TRIANGLE, 0, 1 - 4.0 / 3);
        assertThat(under.area).isEqualTo(2.625, within(ROUND_OFF));
        double x = (6 - 3.375 * 0.75) / 2.625;
        double y = (8 - 3.375 * 2) / 2.625;
        assertThat(under.centroidX).isEqualTo(x - 1, within(ROUND_OFF));
        assertThat(under.centroidY).isEqualTo(y - 4.0 / 3, within(ROUND_OFF));
    }

    /** Turned by any angle and under any level; no part of it is its own mirror image. */
    @ParameterizedTest
    @ValueSource(doubles = {-1.9, -1.2, -0.7, -0.1, 0, 0.45, 1, 1.6})
    void polygonsAsTheSumOfStrips(double level) {
        for (double angle = -3; angle < 3.2; angle += 0.37) {
            measure(TRIANGLE, angle, level);
            require(Strips.of(TRIANGLE, angle, level), 10 * ROUND_OFF);
            measure(PENTAGON, angle, level);
            require(Strips.of(PENTAGON, angle, level), 10 * ROUND_OFF);
        }
    }

    /** A corner or a side on the level is under it or not: nothing jumps. */
    @Test
    void aSideOnTheLevel() {
        measure(Polygon.box(2, 1), 0, 0.5);
        require(2, 0, 0, 2 * (4 + 1) / 12.0);
        measure(Polygon.box(2, 1), 0, -0.5);
        require(0, 0, 0, 0);
    }

    /** The previous measurement is forgotten. */
    @ParameterizedTest
    @ValueSource(doubles = {-1.5, -2, -100, Double.NaN})
    void nothingUnderWater(double level) {
        measure(new Circle(1), 0, 0.5);
        measure(new Circle(1.5), 0, level);
        require(0, 0, 0, 0);
        measure(Polygon.box(2, 1), 0.2, 0.3);
        measure(Polygon.box(2, 1), 0, level);
        require(0, 0, 0, 0);
    }

    /** A capsule upright to its middle: half the rectangle, 2r·h, and half a disc below it. */
    @Test
    void halfACapsuleOnItsEnd() {
        double h = 0.8;
        double r = 0.3;
        measure(new Capsule(h, r), Math.PI / 2, 0);
        double rectangle = 2 * r * h;
        double half = Math.PI * r * r / 2;
        double down = 4 * r / (3 * Math.PI);
        double y = (-rectangle * h / 2 - half * (h + down)) / (rectangle + half);
        double second =
                rectangle * (4 * r * r + h * h) / 12
                        + rectangle * h * h / 4
                        + half * r * r / 2
                        - half * down * down
                        + half * (h + down) * (h + down);
        require(rectangle + half, 0, y, second);
    }

    /**
     * The part below a level and the part above it, which is the part below for the body upside
     * down, add up to the whole.
     */
    @ParameterizedTest
    @ValueSource(doubles = {-0.9, -0.4, -0.01, 0, 0.33, 0.7, 1.1})
    void theRestOfWhatIsRoundIsAboveTheLevel(double level) {
        for (Shape shape : new Shape[] {new Capsule(0.8, 0.3), PENTAGON.rounded(0.2)}) {
            for (double angle = -3; angle < 3.2; angle += 0.37) {
                measure(shape, angle, level);
                double area = under.area;
                double momentX = under.area * under.centroidX;
                double momentY = under.area * under.centroidY;
                double second = under.secondMoment;
                measure(shape, angle + Math.PI, -level);
                double most = 10 * ROUND_OFF;
                assertThat(area + under.area).isEqualTo(shape.area(), within(most));
                assertThat(momentX).isEqualTo(under.area * under.centroidX, within(most));
                assertThat(momentY).isEqualTo(under.area * under.centroidY, within(most));
                assertThat(second + under.secondMoment)
                        .isEqualTo(shape.massProperties(1).inertia(), within(most));
            }
        }
    }
}
