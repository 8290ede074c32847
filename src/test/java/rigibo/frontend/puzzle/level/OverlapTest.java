package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
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
        assertThat(Overlap.depth(Footprint.of(a), Footprint.of(b)))
                .isCloseTo(metres, within(ROUNDING));
        assertThat(Overlap.depth(Footprint.of(b), Footprint.of(a)))
                .isCloseTo(metres, within(ROUNDING));
    }

    @Test
    void boxesOverlapAlongTheirShallowerAxis() {
        assertDepth(box(0, 0, 0), box(0.9, 0.2, 0), 0.1);
        assertDepth(box(0, 0, 0), box(1.25, 0, 0), -0.25);
    }

    /** A unit square on its corner extends √½ from its centre. */
    @Test
    void aTurnedBoxReachesFurther() {
        assertDepth(box(0, 0, 0), box(1.2, 0, Math.PI / 4), 0.5 + Math.sqrt(0.5) - 1.2);
    }

    @Test
    void discsMeasureTheirCentres() {
        assertDepth(disc(0, 0), disc(0.6, 0.6), 1 - 0.6 * Math.sqrt(2));
    }

    /** Near a corner the distance is that to the corner, not to an edge's line. */
    @Test
    void aDiscNearACornerIsApartAlthoughBothEdgesSeeItNear() {
        assertDepth(box(0, 0, 0), disc(0.9, 0.9), 0.5 - 0.4 * Math.sqrt(2));
    }

    @Test
    void aDiscInsideABoxIsAsDeepAsTheNearestEdgeAndItsRadius() {
        assertDepth(box(0, 0, 0), disc(0.3, 0), 0.7);
    }

    /** Cores of 1 m at right angles, with nearest points 0.7 m apart and radii of 0.2 m. */
    @Test
    void capsulesMeasureTheirCoresAndRadii() {
        BodyDefinition lying = BodyDefinition.fixed(new Capsule(0.5, 0.2));
        BodyDefinition standing = lying.at(0.3, 1.2).angle(Math.PI / 2);
        assertDepth(lying, standing, 0.4 - 0.7);
        assertDepth(lying, lying.at(0.2, 0.1), 0.4 - 0.1);
    }

    /** At its corner a rounded box of 1 m with a radius of 0.2 m extends 0.3·√2 + 0.2 m. */
    @Test
    void aRoundedCornerIsPassedNearer() {
        BodyDefinition box = BodyDefinition.fixed(Polygon.box(0.6, 0.6).rounded(0.2));
        double reach = 0.3 * Math.sqrt(2) + 0.2 + 0.5;
        double away = 0.75;
        assertDepth(box, disc(away, away), reach - away * Math.sqrt(2));
    }

    @Test
    void aCompoundIsAsDeepAsItsDeepestPart() {
        Compound ell =
                Compound.of(
                        Part.of(Polygon.box(2, 0.5)), Part.of(Polygon.box(0.5, 2)).at(-0.75, 1));
        BodyDefinition placed = BodyDefinition.fixed(ell).at(ell.centroidX(), ell.centroidY());
        // In its dent, 0.1 m from the upright part.
        assertDepth(placed, disc(0.1, 0.95), -0.1);
        assertDepth(placed, disc(0.1, 0.6), 0.15);
    }
}
