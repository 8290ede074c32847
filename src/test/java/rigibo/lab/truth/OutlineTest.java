package rigibo.lab.truth;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

/** The gap between two outlines, by hand. */
class OutlineTest {

    /** Of lengths below 10 m that a few operations worked out, m. */
    private static final double ROUND_OFF = 1e-14;

    private static final Capsule CAPSULE = new Capsule(0.5, 0.2);

    private static double gap(Shape a, double x, double y, double angle, Shape b) {
        Outline one = new Outline(a);
        Outline other = new Outline(b);
        one.place(x, y, angle);
        other.place(0, 0, 0);
        assertEquals(one.separation(other), other.separation(one), ROUND_OFF);
        return one.separation(other);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.1, 0, 0.1, 2})
    void capsulesThatPointAtEachOtherAreTheirLengthApart(double gap) {
        assertEquals(gap, gap(CAPSULE, 1.4 + gap, 0, 0, CAPSULE), ROUND_OFF);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.1, 0, 0.1, 2})
    void capsulesSideBySideAreTheirWidthApart(double gap) {
        assertEquals(gap, gap(CAPSULE, 0.3, 0.4 + gap, 0, CAPSULE), ROUND_OFF);
    }

    @Test
    void capsulesThatCrossOverlapByTheShortestWayOut() {
        // Across by its own half core and both radii, from 0.1 m beyond the middle.
        assertEquals(-(0.4 + 0.4), gap(CAPSULE, 0, 0.1, Math.PI / 2, CAPSULE), ROUND_OFF);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.05, 0, 0.1})
    void roundCornersComeAsNearAsTheirCentres(double gap) {
        Polygon box = Polygon.box(1, 1).rounded(0.1);
        // From corner of core to corner of core, along the diagonal.
        double diagonal = (gap + 0.2) / Math.sqrt(2);
        double away = 2 * coreX(box) + diagonal;
        assertEquals(gap, gap(box, away, away, 0, box), ROUND_OFF);
    }

    private static double coreX(Shape box) {
        return Math.abs(box.outline(0).cornerX(0));
    }

    @Test
    void aDiscComesAsNearAsItsRadius() {
        assertEquals(0.2, gap(new Circle(0.3), 1.2, 0, 0, CAPSULE), ROUND_OFF);
        assertEquals(-0.1, gap(new Circle(0.3), 0, 0.4, 0, CAPSULE), ROUND_OFF);
    }
}
