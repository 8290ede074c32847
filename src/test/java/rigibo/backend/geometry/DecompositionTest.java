package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;

import java.util.Random;

/** Outlines with dents as convex pieces, and hulls of points. */
class DecompositionTest {

    /** Area, inertia and centroid are those of the outline itself, by the shoelace sums. */
    @RepeatedTest(200)
    void piecesWeighWhatTheOutlineDoes(RepetitionInfo info) {
        double[] outline = star(new Random(info.getCurrentRepetition()));
        Compound compound = Compound.ofOutline(outline);
        MassProperties whole = MassProperties.ofPolygon(1, outline);

        assertThat(compound.area()).isEqualTo(whole.mass(), within(1e-12));
        assertThat(compound.massProperties(1).inertia()).isEqualTo(whole.inertia(), within(1e-12));
        assertThat(compound.centroidX()).isEqualTo(whole.centroidX(), within(1e-12));
        assertThat(compound.parts()).isLessThan(outline.length / 2 - 1);
    }

    /** As many as there are dents and one, for each needs a cut: four times that at most. */
    @Test
    void piecesAreFew() {
        assertThat(Compound.ofOutline(0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2).parts()).isEqualTo(2);
        assertThat(Compound.ofOutline(0, 0, 3, 0, 2, 2, 1, 2).parts()).isEqualTo(1);
        double[] cross = {1, 0, 2, 0, 2, 1, 3, 1, 3, 2, 2, 2, 2, 3, 1, 3, 1, 2, 0, 2, 0, 1, 1, 1};
        assertThat(Compound.ofOutline(cross).parts()).isBetween(3, 5);
    }

    @Test
    void outlinesThatAreNoneAreRefused() {
        assertThatThrownBy(() -> Compound.ofOutline(0, 0, 2, 2, 2, 0, 0, 2))
                .hasMessageContaining("edges must not cross: those from corner 0");
        assertThatThrownBy(() -> Compound.ofOutline(0, 0, 0, 2, 2, 2, 2, 0))
                .hasMessageContaining("counter-clockwise");
        assertThatThrownBy(() -> Compound.ofOutline(0, 0, 2, 0, 2, 0, 2, 2))
                .hasMessageContaining("corner 2 is repeated at (2.0, 0.0) m");
        assertThatThrownBy(() -> Compound.ofOutline(0, 0, 2, 0))
                .hasMessageContaining("3 to 256 corners, was 4 numbers");
        assertThatThrownBy(() -> Compound.ofOutline(0, 0, Double.NaN, 0, 1, 1))
                .hasMessageContaining("corner 1 must be finite");
    }

    /** Every point is inside, and every corner is one of them. */
    @RepeatedTest(100)
    void aHullHoldsItsPoints(RepetitionInfo info) {
        Random random = new Random(info.getCurrentRepetition());
        double[] points = random.doubles(2L * (3 + random.nextInt(60)), -1, 1).toArray();
        Polygon hull = Polygon.hull(points);
        for (int i = 0; i < points.length; i += 2) {
            double x = points[i] - hull.centroidX();
            double y = points[i + 1] - hull.centroidY();
            assertThat(hull.outline().depth(x, y)).isGreaterThan(-1e-9);
        }
        for (int i = 0; i < hull.corners(); i++) {
            double x = hull.cornerX(i) + hull.centroidX();
            double y = hull.cornerY(i) + hull.centroidY();
            double nearest = Double.POSITIVE_INFINITY;
            for (int j = 0; j < points.length; j += 2) {
                nearest = Math.min(nearest, Math.hypot(points[j] - x, points[j + 1] - y));
            }
            assertThat(nearest).isLessThan(1e-12);
        }
    }

    @Test
    void whatLiesOnAnEdgeIsNoCorner() {
        Polygon hull = Polygon.hull(0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1, 1, 1, 0, 0);

        assertThat(hull.corners()).isEqualTo(4);
        assertThat(hull.area()).isEqualTo(4, within(1e-15));
    }

    @Test
    void pointsWithoutAHullAreRefused() {
        assertThatThrownBy(() -> Polygon.hull(0, 0, 1, 1, 2, 2))
                .hasMessage(
                        "Polygon.hull must have 3 to 256 corners, had 2: all points lie on one"
                                + " line");
        assertThatThrownBy(() -> Polygon.hull(0, 0, 1)).hasMessageContaining("x, y pairs");
        assertThatThrownBy(() -> Polygon.hull(0, 0, 1, 1 / 0.0, 0, 1))
                .hasMessageContaining("Polygon.hull corner 1");
    }

    /** Round a point once, at random distances from it: simple, and full of dents. */
    private static double[] star(Random random) {
        int corners = 6 + random.nextInt(30);
        double[] xy = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * (i + 0.8 * random.nextDouble()) / corners;
            double reach = 0.3 + random.nextDouble();
            xy[2 * i] = 5 + reach * Math.cos(angle);
            xy[2 * i + 1] = reach * Math.sin(angle);
        }
        return xy;
    }
}
