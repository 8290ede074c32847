package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

class PolygonTest {

    private static final double ROUND_OFF = 1e-14;

    /** I = m(w² + h²)/12. */
    @Test
    void boxHasTheMassAndInertiaOfAPlate() {
        MassProperties plate = Polygon.box(3, 2).massProperties(5);

        assertThat(plate.mass()).isEqualTo(30, within(ROUND_OFF));
        assertThat(plate.inertia()).isEqualTo(30 * 13.0 / 12, within(1e-13));
    }

    /** Right triangle with legs 3 and 6: centroid at a third of each, I = A(a² + b²)/18. */
    @Test
    void triangleIsMovedToItsCentroid() {
        Polygon triangle = Polygon.of(10, 20, 13, 20, 10, 26);

        assertThat(triangle.cornerX(0)).isEqualTo(-1, within(ROUND_OFF));
        assertThat(triangle.cornerY(0)).isEqualTo(-2, within(ROUND_OFF));
        assertThat(triangle.area()).isEqualTo(9, within(ROUND_OFF));
        assertThat(triangle.massProperties(2).inertia())
                .isEqualTo(2 * 9 * 45.0 / 18, within(1e-13));
    }

    /** Regular n-gon: A = ½nr² sin(2π/n), I = A r²(2 + cos(2π/n))/6, width by its symmetry. */
    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 16, 255, 256})
    void regularPolygonHasTheClosedForms(int corners) {
        Polygon polygon = Polygon.regular(corners, 0.5);
        double turn = 2 * Math.PI / corners;
        double area = corners * 0.25 * Math.sin(turn) / 2;
        double apothem = 0.5 * Math.cos(turn / 2);
        double width = apothem + (corners % 2 == 0 ? apothem : 0.5);

        assertThat(polygon.area()).isEqualTo(area, within(ROUND_OFF));
        assertThat(polygon.massProperties(1).inertia())
                .isEqualTo(area * 0.25 * (2 + Math.cos(turn)) / 6, within(ROUND_OFF));
        assertThat(polygon.boundingRadius()).isEqualTo(0.5, within(ROUND_OFF));
        assertThat(polygon.smallestWidth()).isEqualTo(width, within(ROUND_OFF));
    }

    @Test
    void normalsPointOutwardsAndAreUnitVectors() {
        Polygon box = Polygon.box(4, 2);

        assertThat(box.normalX(0)).isEqualTo(0);
        assertThat(box.normalY(0)).isEqualTo(-1);
        assertThat(box.normalX(1)).isEqualTo(1);
        assertThat(box.normalY(2)).isEqualTo(1);
        assertThat(box.normalX(3)).isEqualTo(-1);
    }

    /** A symmetric rack stays symmetric only if its boxes are. */
    @Test
    void boxIsItsOwnMirrorImageToTheBit() {
        Random random = new Random(1);
        for (int i = 0; i < 10_000; i++) {
            double width = random.nextDouble() * 3;
            Polygon box = Polygon.box(width, random.nextDouble());
            assertThat(box.cornerX(1)).isEqualTo(width / 2);
            assertThat(box.cornerX(0)).isEqualTo(-width / 2);
            assertThat(box.cornerY(2)).isEqualTo(-box.cornerY(1));
        }
    }

    /** Stated from its own corners, which lie about the centroid already, a polygon is the same. */
    @Test
    void cornersAboutTheCentroidStayAsTheyAre() {
        Polygon first = Polygon.of(10, 20, 13, 20.5, 12, 26, 10, 25);
        double[] xy = new double[8];
        for (int i = 0; i < 4; i++) {
            xy[2 * i] = first.cornerX(i);
            xy[2 * i + 1] = first.cornerY(i);
        }
        assertThat(Polygon.of(xy)).isEqualTo(first).hasSameHashCodeAs(first);
    }

    /** The centroid of a triangle is the mean of its corners. */
    @Test
    void placedAtItsCentroidAPolygonHasItsCornersWhereTheyWereStated() {
        double[] stated = {10, 20, 13, 20, 10, 21.5};
        Polygon wedge = Polygon.of(stated);
        assertThat(wedge.centroidX()).isEqualTo(11, within(ROUND_OFF));
        assertThat(wedge.centroidY()).isEqualTo(20.5, within(ROUND_OFF));
        for (int i = 0; i < wedge.corners(); i++) {
            assertThat(wedge.centroidX() + wedge.cornerX(i))
                    .isEqualTo(stated[2 * i], within(ROUND_OFF));
            assertThat(wedge.centroidY() + wedge.cornerY(i))
                    .isEqualTo(stated[2 * i + 1], within(ROUND_OFF));
        }
    }

    /** Where the points are given must not matter, as far as coordinates can tell. */
    @Test
    void smallPolygonFarFromTheOriginKeepsItsPrecision() {
        Polygon near = Polygon.of(0, 0, 0.25, 0, 0.25, 0.125, 0, 0.125);
        Polygon far = Polygon.of(1e9, 0, 1e9 + 0.25, 0, 1e9 + 0.25, 0.125, 1e9, 0.125);

        assertThat(far.area()).isEqualTo(near.area());
        assertThat(far.massProperties(1).inertia())
                .isEqualTo(near.massProperties(1).inertia(), within(1e-16));
    }

    @Test
    void boundsHoldTheTurnedCorners() {
        Aabb bounds = new Aabb();
        // By 3-4-5 about (10, 20): corners at ±(2·0.6 + 1·0.8) and ±(2·0.8 + 1·0.6).
        Polygon.box(4, 2).bounds(10, 20, 0.6, 0.8, bounds);

        assertThat(bounds.minX).isEqualTo(8, within(ROUND_OFF));
        assertThat(bounds.maxX).isEqualTo(12, within(ROUND_OFF));
        assertThat(bounds.minY).isEqualTo(17.8, within(ROUND_OFF));
        assertThat(bounds.maxY).isEqualTo(22.2, within(ROUND_OFF));
    }

    @Test
    void widthOfASliverIsItsThickness() {
        assertThat(Polygon.box(2, 2e-4).smallestWidth()).isEqualTo(2e-4, within(1e-18));
        // A triangle is narrowest across its longest side: 2A/c.
        assertThat(Polygon.of(0, 0, 4, 0, 0, 3).smallestWidth()).isEqualTo(2.4, within(ROUND_OFF));
    }
}
