package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class CoveredEdgesTest {

    private static final double ROUND_OFF = 1e-5;

    /**
     * The left one of two boxes of 1 m × 1 m side by side; the right one may be of another height.
     */
    private static Outline left(double heightOfRight) {
        Compound two =
                Compound.of(
                        Part.of(Polygon.box(1, 1)).at(-0.5, 0),
                        Part.of(Polygon.box(1, heightOfRight)).at(0.5, (heightOfRight - 1) / 2));
        return two.outline(0);
    }

    /** Where a direction leads that is turned by so many rad from straight up to the right. */
    private static int leads(Outline outline, double turned) {
        return outline.leads(Math.sin(turned), Math.cos(turned), ROUND_OFF);
    }

    @Test
    void nothingLeavesThroughACoveredEdgeNorPastItsCorner() {
        Outline outline = left(1);
        assertThat(leads(outline, 0)).isEqualTo(Outline.OUT);
        assertThat(leads(outline, 1e-6)).isEqualTo(Outline.OUT);
        assertThat(leads(outline, Math.PI / 2)).isEqualTo(Outline.INSIDE);
        int corner = leads(outline, 1e-3);
        assertThat(corner).isNotNegative().isEqualTo(leads(outline, 1.5));
        assertThat(outline.outermostX(corner)).isCloseTo(0, within(2e-6));
        assertThat(outline.outermostY(corner)).isCloseTo(1, within(2e-6));
        // Below, the same corner's edge begins.
        int below = leads(outline, Math.PI - 1e-3);
        assertThat(below).isNotNegative().isNotEqualTo(corner);
        assertThat(outline.outermostY(below)).isCloseTo(-1, within(2e-6));
    }

    @Test
    void cornersOnTheOtherSideAreFree() {
        Outline outline = left(1);
        assertThat(leads(outline, -1e-3)).isEqualTo(Outline.OUT);
        assertThat(leads(outline, -1)).isEqualTo(Outline.OUT);
        assertThat(leads(outline, -Math.PI / 2)).isEqualTo(Outline.OUT);
    }

    /** Half of the edge is free. */
    @Test
    void anEdgeThatIsCoveredInPartIsOneLikeOthers() {
        Outline outline = left(0.5);
        assertThat(leads(outline, Math.PI / 2)).isEqualTo(Outline.OUT);
        assertThat(leads(outline, 0.5)).isEqualTo(Outline.OUT);
    }

    /** A body at the foot of a wall touches the floor and the wall, but not the corner. */
    @Test
    void aHigherNeighbourIsAWall() {
        int corner = leads(left(2), 0.5);
        assertThat(corner).isNotNegative();
        assertThat(left(2).outermostY(corner)).isCloseTo(1, within(2e-6));
    }

    /** The roof of a house is cut along its ridge: up to its other slope the ridge is a corner. */
    @Test
    void aRidgeIsACornerUpToTheOtherSlope() {
        double slope = 0.4;
        double rise = Math.tan(slope);
        Compound roof =
                Compound.of(
                        Part.of(Polygon.of(-1, 0, 0, 0, 0, rise)).at(-1 / 3.0, rise / 3),
                        Part.of(Polygon.of(0, 0, 1, 0, 0, rise)).at(1 / 3.0, rise / 3));
        Outline outline = roof.outline(0);
        assertThat(leads(outline, -slope)).isEqualTo(Outline.OUT);
        assertThat(leads(outline, 0)).isEqualTo(Outline.OUT);
        assertThat(leads(outline, slope - 1e-3)).isEqualTo(Outline.OUT);
        int corner = leads(outline, slope + 1e-3);
        assertThat(corner).isNotNegative();
        assertThat(outline.outermostX(corner)).isCloseTo(Math.sin(slope), within(2e-6));
        assertThat(outline.outermostY(corner)).isCloseTo(Math.cos(slope), within(2e-6));
    }

    /** Strips of a box are as wide as the box, an L as its legs. */
    @Test
    void widthIsThatOfTheWhole() {
        Compound strips =
                Compound.of(
                        Part.of(Polygon.box(0.25, 1)).at(-0.25, 0),
                        Part.of(Polygon.box(0.25, 1)),
                        Part.of(Polygon.box(0.25, 1)).at(0.25, 0));
        assertThat(strips.smallestWidth()).isCloseTo(0.75, within(1e-12));
        Part quarter = Part.of(Polygon.box(0.5, 0.4));
        Compound quarters =
                Compound.of(
                        quarter.at(-0.25, -0.2),
                        quarter.at(0.25, -0.2),
                        quarter.at(0.25, 0.2),
                        quarter.at(-0.25, 0.2));
        assertThat(quarters.smallestWidth()).isCloseTo(0.8, within(1e-12));
        Compound angle =
                Compound.of(
                        Part.of(Polygon.box(0.8, 0.2)),
                        Part.of(Polygon.box(0.2, 0.5)).at(-0.3, 0.35));
        assertThat(angle.smallestWidth()).isCloseTo(0.2, within(1e-12));
        Compound surrounded =
                Compound.of(Part.of(Polygon.box(3, 2)), Part.of(Polygon.box(0.1, 0.1)));
        assertThat(surrounded.smallestWidth()).isCloseTo(2, within(1e-12));
    }
}
