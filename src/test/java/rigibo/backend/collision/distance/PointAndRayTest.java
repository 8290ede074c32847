package rigibo.backend.collision.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.manifold.Meeting.pose;

import org.junit.jupiter.api.Test;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;

class PointAndRayTest {

    private static final double ROUND_OFF = 1e-14;

    /** A box of 2 m by 1 m, turned by a right angle about (10, 0). */
    private static final Polygon BOX = Polygon.box(2, 1);

    private static final Pose UPRIGHT = pose(10, 0, Math.PI / 2);

    private final PointAndRay query = new PointAndRay();

    @Test
    void turnedBoxHoldsWhatIsInsideIt() {
        assertThat(query.holds(BOX.outline(), UPRIGHT, 10.4, 0.9)).isTrue();
        assertThat(query.holds(BOX.outline(), UPRIGHT, 10.6, 0)).isFalse();
        assertThat(query.holds(BOX.outline(), UPRIGHT, 10, 1.1)).isFalse();
    }

    @Test
    void discHoldsItsRim() {
        Circle disc = new Circle(0.5);

        assertThat(query.holds(disc.outline(), pose(1, 1, 0), 1.3, 1.4)).isTrue();
        assertThat(query.holds(disc.outline(), pose(1, 1, 0), 1.31, 1.4)).isFalse();
    }

    @Test
    void rayEntersABoxByTheFaceItMeets() {
        double fraction = query.enters(BOX.outline(), UPRIGHT, 0, 0.5, 20, 0.5);

        assertThat(fraction).isEqualTo(9.5 / 20, within(ROUND_OFF));
        assertThat(query.normalX).isEqualTo(-1, within(ROUND_OFF));
        assertThat(query.normalY).isEqualTo(0, within(ROUND_OFF));
    }

    @Test
    void rayThatPassesOrEndsEarlyMisses() {
        assertThat(query.enters(BOX.outline(), UPRIGHT, 0, 1.1, 20, 1.1))
                .isEqualTo(PointAndRay.MISS);
        assertThat(query.enters(BOX.outline(), UPRIGHT, 0, 0, 9.4, 0)).isEqualTo(PointAndRay.MISS);
        assertThat(query.enters(BOX.outline(), UPRIGHT, 20, 0, 30, 0)).isEqualTo(PointAndRay.MISS);
    }

    @Test
    void rayThatStartsInsideDoesNotEnter() {
        assertThat(query.enters(BOX.outline(), UPRIGHT, 10, 0, 20, 0)).isEqualTo(PointAndRay.MISS);
        assertThat(query.enters(new Circle(1).outline(), UPRIGHT, 10, 0.5, 20, 0.5))
                .isEqualTo(PointAndRay.MISS);
    }

    @Test
    void rayOfNoLengthMisses() {
        assertThat(query.enters(BOX.outline(), UPRIGHT, 0, 0, 0, 0)).isEqualTo(PointAndRay.MISS);
        assertThat(query.enters(new Circle(1).outline(), UPRIGHT, 0, 0, 0, 0))
                .isEqualTo(PointAndRay.MISS);
    }

    /** A disc of radius 5 about the origin and a line at height 3: the ray enters at x = −4. */
    @Test
    void rayEntersADisc() {
        double fraction = query.enters(new Circle(5).outline(), pose(0, 0, 2), -10, 3, 10, 3);

        assertThat(fraction).isEqualTo(0.3, within(ROUND_OFF));
        assertThat(query.normalX).isEqualTo(-0.8, within(ROUND_OFF));
        assertThat(query.normalY).isEqualTo(0.6, within(ROUND_OFF));
    }

    /** A ray from 10⁶ m away passes the centre at 0.06 m and enters 0.08 m before it. */
    @Test
    void rayFromFarAwayEntersASmallDisc() {
        double fraction =
                query.enters(new Circle(0.1).outline(), pose(0, 0, 0), -1e6, 0.06, 1e6, 0.06);

        // Coordinates of 10⁶ m are 10⁻¹⁰ m apart.
        assertThat(fraction * 2e6 - 1e6).isEqualTo(-0.08, within(1e-9));
        assertThat(query.normalY).isEqualTo(0.6, within(1e-8));
    }

    /**
     * A ray from 10¹⁴ m away, where coordinates are 1/64 m apart, which is 0.03 of the radius. It
     * passes the centre at 0.3 of the radius. The place of the hit is uncertain by as much, the
     * length of the normal is not.
     */
    @Test
    void normalHasLengthOneHoweverFarTheRayBegins() {
        query.enters(new Circle(0.5).outline(), pose(0, 0, 1), -1e14, 0.15, 1, 0.15);

        assertThat(Math.hypot(query.normalX, query.normalY)).isEqualTo(1, within(ROUND_OFF));
        assertThat(query.normalY).isEqualTo(0.3, within(0.03));
        assertThat(query.normalX).isNegative();
    }

    /** The square of 10²⁰⁰ is infinite, yet such coordinates are allowed. */
    @Test
    void rayMeetsADiscFromWherePlacesHaveNoSquare() {
        double fraction =
                query.enters(new Circle(0.5).outline(), pose(0, 0, 0), -1e200, 0, 1e200, 0);

        assertThat(fraction).isEqualTo(0.5, within(ROUND_OFF));
        assertThat(query.normalX).isEqualTo(-1, within(ROUND_OFF));
    }

    /** At 0.1 m beside its line, the end cap begins √(0.2² − 0.1²) before the end of the line. */
    @Test
    void aRayEntersACapsuleAtItsEndAndAtItsSide() {
        Capsule capsule = new Capsule(0.5, 0.2);

        double atEnd = query.enters(capsule.outline(), pose(0, 0, 0), -2, 0.1, 2, 0.1);
        assertThat(-2 + 4 * atEnd).isEqualTo(-0.5 - Math.sqrt(0.03), within(1e-15));
        assertThat(query.normalX).isEqualTo(-Math.sqrt(0.75), within(1e-15));
        assertThat(query.normalY).isEqualTo(0.5, within(1e-15));

        double atSide = query.enters(capsule.outline(), pose(0, 0, 0), 0.3, 2, 0.3, -2);
        assertThat(2 - 4 * atSide).isEqualTo(0.2, within(1e-15));
        assertThat(query.normalY).isEqualTo(1);

        assertThat(query.enters(capsule.outline(), pose(0, 0, 0), -2, 0.21, 2, 0.21))
                .isEqualTo(PointAndRay.MISS);
        assertThat(query.enters(capsule.outline(), pose(0, 0, 0), 0.4, 0.1, 2, 0.1))
                .isEqualTo(PointAndRay.MISS);
        assertThat(query.holds(capsule.outline(), pose(0, 0, 0), 0.69, 0)).isTrue();
        assertThat(query.holds(capsule.outline(), pose(0, 0, 0), 0.69, 0.1)).isFalse();
    }
}
