package rigibo.backend.collision.manifold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.manifold.Meeting.pose;

import org.junit.jupiter.api.Test;

import rigibo.backend.geometry.Circle;

class CircleCircleTest {

    private static final double ROUND_OFF = 1e-15;

    private static Meeting discs(double x, double y) {
        return new Meeting(new Circle(1), pose(0, 0, 0), new Circle(0.5), pose(x, y, 1));
    }

    /** The centres are 5 m apart, on a 3-4-5 triangle. */
    @Test
    void gapIsTheCentresDistanceLessTheRadii() {
        Manifold manifold = discs(3, 4).within(10);

        assertThat(manifold.count).isEqualTo(1);
        assertThat(manifold.separation[0]).isEqualTo(3.5);
        assertThat(manifold.normalX).isEqualTo(0.6, within(ROUND_OFF));
        assertThat(manifold.normalY).isEqualTo(0.8, within(ROUND_OFF));
        assertThat(manifold.source).isEqualTo(NormalSource.CLOSEST_POINTS);
        // The surfaces are 1 m and 4.5 m along the normal.
        assertThat(manifold.pointX[0]).isEqualTo(0.6 * 2.75, within(ROUND_OFF));
        assertThat(manifold.pointY[0]).isEqualTo(0.8 * 2.75, within(ROUND_OFF));
    }

    @Test
    void overlapIsNegative() {
        Manifold manifold = discs(0, 1.25).within(0);

        assertThat(manifold.separation[0]).isEqualTo(-0.25);
        assertThat(manifold.normalY).isEqualTo(1);
        assertThat(manifold.pointY[0]).isEqualTo(0.875);
    }

    @Test
    void nothingBeyondReach() {
        assertThat(discs(2, 0).within(0.499).count).isZero();
        assertThat(discs(2, 0).within(0.5).count).isEqualTo(1);
    }

    /** No direction is preferred, but there must be one, and always the same. */
    @Test
    void concentricDiscsHaveAnAxis() {
        Manifold manifold = discs(0, 0).within(0);

        assertThat(manifold.separation[0]).isEqualTo(-1.5);
        assertThat(manifold.normalX).isEqualTo(0);
        assertThat(manifold.normalY).isEqualTo(1);
    }

    /** The centres are one step of a double apart. */
    @Test
    void nearlyConcentricDiscsHaveAUnitNormal() {
        Manifold manifold = discs(Double.MIN_NORMAL, 0).within(0);

        assertThat(Math.hypot(manifold.normalX, manifold.normalY)).isEqualTo(1);
    }
}
