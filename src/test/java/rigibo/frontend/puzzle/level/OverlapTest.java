package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

class OverlapTest {

    private static final double ROUNDING = 1e-12;

    private static BodyDefinition box(double x, double y, double angle) {
        return BodyDefinition.fixed(Polygon.box(1, 1)).at(x, y).angle(angle);
    }

    private static BodyDefinition disc(double x, double y) {
        return BodyDefinition.fixed(new Circle(0.5)).at(x, y);
    }

    private static void assertDepth(BodyDefinition a, BodyDefinition b, double metres) {
        Footprint first = Footprint.of(a);
        Footprint second = Footprint.of(b);
        assertThat(Overlap.depth(first, second)).isCloseTo(metres, within(ROUNDING));
        assertThat(Overlap.depth(second, first)).isCloseTo(metres, within(ROUNDING));
    }

    @Test
    void boxesOverlapAlongTheirShallowerAxis() {
        assertDepth(box(0, 0, 0), box(0.9, 0.2, 0), 0.1);
        assertDepth(box(0, 0, 0), box(1.25, 0, 0), -0.25);
    }

    /** A unit square on its corner reaches √½ from its centre. */
    @Test
    void aTurnedBoxReachesFurther() {
        assertDepth(box(0, 0, 0), box(1.2, 0, Math.PI / 4), 0.5 + Math.sqrt(0.5) - 1.2);
    }

    @Test
    void discsMeasureTheirCentres() {
        assertDepth(disc(0, 0), disc(0.6, 0.6), 1 - 0.6 * Math.sqrt(2));
    }

    /** Near a corner the distance goes to the corner, not to an edge's line. */
    @Test
    void aDiscNearACornerIsApartAlthoughBothEdgesSeeItNear() {
        assertDepth(box(0, 0, 0), disc(0.9, 0.9), 0.5 - 0.4 * Math.sqrt(2));
    }

    @Test
    void aDiscInsideABoxIsAsDeepAsTheNearestEdgeAndItsRadius() {
        assertDepth(box(0, 0, 0), disc(0.3, 0), 0.7);
    }
}
