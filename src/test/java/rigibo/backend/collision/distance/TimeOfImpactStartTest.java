package rigibo.backend.collision.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.distance.Motions.gap;
import static rigibo.backend.collision.distance.Motions.moving;
import static rigibo.backend.collision.distance.Motions.resting;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.ImpactSearch;

/** Pairs that are already close, touch, or overlap when the search begins. */
class TimeOfImpactStartTest {

    private static final double TOLERANCE = 1e-4;
    private static final double STEP = 1.0 / 60;

    /** A tenth of the tolerance: closer than any impact brings a pair. */
    private static final double CLOSE = 1e-5;

    /** Four units in the last place of the floor's ends, at 20 m. */
    private static final double ROUNDING = 4 * Math.ulp(20.0);

    private final TimeOfImpact impact = new TimeOfImpact();
    private final Motion floor = resting(Polygon.box(40, 1), 0, -0.5, 0);

    private double find(Motion other) {
        return impact.find(floor, other, 0, STEP, TOLERANCE, ImpactSearch.ITP);
    }

    private static Motion discAt(double height, double velocityY) {
        return moving(new Circle(1), 0, 1 + height, 0, velocityY);
    }

    @Test
    void closePairThatPartsIsNotReported() {
        assertThat(find(discAt(CLOSE, 0.001))).isEqualTo(TimeOfImpact.NEVER);
    }

    @Test
    void closePairThatKeepsItsDistanceIsNotReported() {
        Motion sliding = discAt(CLOSE, 0);
        sliding.velocityX = 5;

        assertThat(find(sliding)).isEqualTo(TimeOfImpact.NEVER);
    }

    @Test
    void closePairThatClosesIsReportedAtHalfItsGap() {
        Motion box = moving(Polygon.box(2, 2), 0, 1 + CLOSE, 0, -1);

        double time = find(box);

        assertThat(gap(floor, box, time)).isBetween(CLOSE / 2, CLOSE);
    }

    @Test
    void closeDiscThatClosesIsReportedWhereItTouches() {
        Motion disc = discAt(CLOSE, -1);

        double time = find(disc);

        assertThat(gap(floor, disc, time)).isBetween(7 * ROUNDING, 9 * ROUNDING);
    }

    /** A disc thrown up at 0.05 m/s is back after 2v/g = 10.2 ms. */
    @Test
    void closePairThatReturnsIsReported() {
        Motion disc = discAt(CLOSE, 0.05);
        disc.accelerationY = -9.81;

        double time = find(disc);

        // Half of the first gap of 10 µm is left, at 0.05 m/s.
        assertThat(time).isEqualTo(2 * 0.05 / 9.81, within(CLOSE / 0.05));
        assertThat(gap(floor, disc, time)).isPositive();
    }

    @Test
    void overlapThatClosesIsReportedAtOnce() {
        assertThat(find(discAt(-CLOSE, -0.001))).isZero();
    }

    @Test
    void overlapThatPartsIsNotReported() {
        assertThat(find(discAt(-CLOSE, 0.001))).isEqualTo(TimeOfImpact.NEVER);
    }

    @Test
    void touchingPairPressedTogetherIsReportedAtOnce() {
        Motion disc = discAt(0, 0);
        disc.accelerationY = -9.81;

        assertThat(find(disc)).isZero();
    }

    @Test
    void touchingPairThatPartsIsNotReported() {
        assertThat(find(discAt(0, 0.001))).isEqualTo(TimeOfImpact.NEVER);
    }

    /**
     * A box that falls beside a standing one does not meet it, though their common face is upright
     * only to round-off: 10⁻¹⁶ of its weight would press.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-16, -1e-16})
    void roundOffOfTheAxisPressesNothing(double tilt) {
        Motion standing = resting(Polygon.box(1, 1), 0, 0, tilt);
        Motion falling = moving(Polygon.box(1, 1), 1, 0, 0, 0);
        falling.accelerationY = -9.81;

        assertThat(impact.find(standing, falling, 0, STEP, TOLERANCE, ImpactSearch.ITP))
                .isEqualTo(TimeOfImpact.NEVER);
    }

    /**
     * A body lifted out of an overlap is reported when it comes back, deeper by at most the
     * tolerance.
     */
    @Test
    void overlapThatReturnsIsReported() {
        Motion disc = discAt(-CLOSE, 0.05);
        disc.accelerationY = -9.81;

        double time = find(disc);

        assertThat(time).isEqualTo(2 * 0.05 / 9.81, within(TOLERANCE / 0.05));
        assertThat(gap(floor, disc, time)).isGreaterThan(-CLOSE - TOLERANCE);
    }

    /** Concentric discs have no direction; the search must end, and no value may be NaN. */
    @Test
    void concentricDiscsGiveAnAnswer() {
        Motion a = resting(new Circle(1), 0, 0, 0);
        Motion b = moving(new Circle(0.5), 0, 0, 0, 3);

        assertThat(impact.find(a, b, 0, STEP, TOLERANCE, ImpactSearch.ITP))
                .isEqualTo(TimeOfImpact.NEVER);
    }

    /**
     * A rod turns about its middle, flat on a disc. Its ends move along the normal, but its point
     * of contact does not, so that the gap does not close.
     */
    @Test
    void turningRodThatTouchesAtItsMiddleDoesNotClose() {
        Motion disc = resting(new Circle(0.5), 0, 0, 0);
        Motion rod = moving(Polygon.box(4, 0.2), 0, 0.6 + CLOSE, 0, 0.5);
        rod.spin = 3;

        assertThat(impact.find(disc, rod, 0, STEP, TOLERANCE, ImpactSearch.ITP))
                .isEqualTo(TimeOfImpact.NEVER);
    }
}
