package rigibo.backend.collision.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.distance.Motions.gap;
import static rigibo.backend.collision.distance.Motions.moving;
import static rigibo.backend.collision.distance.Motions.resting;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.ImpactSearch;

/** Impacts whose time has a closed form. */
class TimeOfImpactTest {

    private static final double FINEST = 1e-9;
    private static final double STEP = 1.0 / 60;

    private final TimeOfImpact impact = new TimeOfImpact();

    private double find(Motion a, Motion b, double end, double tolerance) {
        return impact.find(a, b, 0, end, tolerance, ImpactSearch.ITP);
    }

    /** Smallest gap that differs from none, m: four units in the last place. */
    private static double rounding(double farthest) {
        return 4 * Math.ulp(farthest);
    }

    /** Two discs of 0.1 m, 2 m apart, close at 400 m/s and touch after 1.8/400 s. */
    @Test
    void bulletsMeetHeadOn() {
        Motion a = moving(new Circle(0.1), -1, 0, 200, 0);
        Motion b = moving(new Circle(0.1), 1, 0, -200, 0);

        double time = find(a, b, STEP, FINEST);

        // Coordinates are up to 1.1 m: nine roundings are 8e-15 m, which 400 m/s cross in 2e-17 s.
        assertThat(time).isEqualTo(1.8 / 400, within(1e-16));
        assertThat(gap(a, b, time)).isBetween(7 * rounding(1.1), 9 * rounding(1.1));
    }

    /**
     * Two discs pass at an offset of one radius: their centres are 0.2 m apart when one is √3/2 ·
     * 0.2 ahead.
     */
    @Test
    void bulletsMeetOffCentre() {
        Motion a = moving(new Circle(0.1), -1, 0, 200, 0);
        Motion b = moving(new Circle(0.1), 1, 0.1, -200, 0);

        double truth = (2 - Math.sqrt(3) / 2 * 0.2) / 400;

        assertThat(find(a, b, STEP, FINEST)).isEqualTo(truth, within(1e-12));
    }

    /** y = 1.001 − ½gt² reaches 1 at √(2·0.001/g) = 14.3 ms. */
    @ParameterizedTest
    @EnumSource(ImpactSearch.class)
    void discFallsOnAFloor(ImpactSearch search) {
        Motion floor = resting(Polygon.box(40, 1), 0, -0.5, 0);
        Motion disc = resting(new Circle(1), 3, 1.001, 0);
        disc.accelerationY = -9.81;

        double time = impact.find(floor, disc, 0, STEP, FINEST, search);

        // The floor extends to 20 m: nine roundings are 1.3e-13 m, crossed at 0.14 m/s in 9e-13 s.
        assertThat(time).isEqualTo(Math.sqrt(2 * 0.001 / 9.81), within(1e-12));
        assertThat(gap(floor, disc, time)).isBetween(7 * rounding(20), 9 * rounding(20));
    }

    /** With drag k the displacement is v(1 − e^(−kt))/k, so 0.5 m take −ln(1 − 0.5k/v)/k. */
    @Test
    void dragDelaysAnImpact() {
        Motion wall = resting(Polygon.box(1, 1), 2, 0, 0);
        Motion disc = moving(new Circle(0.5), 0.5, 0, 100, 0);
        disc.drag = 30;

        double truth = -Math.log(1 - 0.5 * 30 / 100) / 30;

        assertThat(find(wall, disc, STEP, FINEST)).isEqualTo(truth, within(1e-11));
    }

    /**
     * A box of 1 m turns about its centre, which is 0.7 m from a wall. Its corner, √½ from the
     * centre, starts at 45° + 20° and reaches 0.7 m at arccos(0.7/√½) from the wall's normal.
     */
    @Test
    void cornerOfATurningBoxReachesAWall() {
        Motion wall = resting(Polygon.box(1, 4), 0.7 + 0.5, 0, 0);
        Motion box = resting(Polygon.box(1, 1), 0, 0, Math.toRadians(20));
        box.spin = -20;

        double truth = (Math.toRadians(65) - Math.acos(0.7 / Math.sqrt(0.5))) / 20;
        double closing = 20 * Math.sqrt(0.5 - 0.49);

        assertThat(find(wall, box, 0.1, FINEST)).isEqualTo(truth, within(FINEST / 4 / closing));
    }

    /**
     * The bullet passes the wall within half a microsecond; at both ends of the step it is clear.
     */
    @Test
    void fastBulletMeetsAThinWall() {
        Motion wall = resting(Polygon.box(0.001, 2), 10, 0, 0);
        Motion bullet = moving(new Circle(0.05), 0, 0, 2000, 0);

        double truth = (10 - 0.0005 - 0.05) / 2000;

        // A quarter of the tolerance, for a wall of a millimetre, at 2000 m/s.
        assertThat(find(wall, bullet, 1.0 / 30, 1e-4)).isEqualTo(truth, within(1e-7 / 4 / 2000));
    }

    /**
     * A disc of 0.1 m passes the corner of a box at 100 m/s, clear of it by a tenth of a
     * millimetre.
     */
    @Test
    void grazingDiscMissesByATenthOfAMillimetre() {
        Motion box = resting(Polygon.box(1, 1), 0, 0, 0);

        assertThat(find(box, moving(new Circle(0.1), -1, 0.6001, 100, 0), STEP, 1e-4))
                .isEqualTo(TimeOfImpact.NEVER);
        assertThat(find(box, moving(new Circle(0.1), -1, 0.6001, 100, 0), STEP, FINEST))
                .isEqualTo(TimeOfImpact.NEVER);
    }

    /**
     * With the centre at 0.5999 m the disc meets the corner √(0.1² − 0.0999²) before it passes it.
     */
    @Test
    void grazingDiscHitsByATenthOfAMillimetre() {
        Motion box = resting(Polygon.box(1, 1), 0, 0, 0);
        Motion disc = moving(new Circle(0.1), -1, 0.5999, 100, 0);

        double ahead = Math.sqrt(0.1 * 0.1 - 0.0999 * 0.0999);

        // The gap closes at 100 m/s times the cosine of the normal, ahead/0.1 = 0.045.
        assertThat(find(box, disc, STEP, FINEST))
                .isEqualTo((0.5 - ahead) / 100, within(FINEST / 4 / 4.4));
    }

    @Test
    void ballPassesAGapTwoMillimetresWider() {
        Motion above = resting(Polygon.box(1, 1), 0, 1, 0);
        Motion below = resting(Polygon.box(1, 1), 0, -1, 0);
        Motion ball = moving(new Circle(0.499), -5, 0, 100, 0);

        assertThat(find(above, ball, 0.1, 1e-4)).isEqualTo(TimeOfImpact.NEVER);
        assertThat(find(below, ball, 0.1, 1e-4)).isEqualTo(TimeOfImpact.NEVER);
    }

    /**
     * Squares stand on their corners. With an offset δ a corner meets a face of 45° when the
     * centres are √2 − |δ| apart.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-9, -1e-9, 1e-4, -1e-4})
    void cornersMeet(double offset) {
        Motion lower = resting(Polygon.box(1, 1), 0, 0, Math.PI / 4);
        Motion upper = moving(Polygon.box(1, 1), offset, 1.5, 0, -10);
        upper.angle = Math.PI / 4;

        double truth = (1.5 - Math.sqrt(2) + Math.abs(offset)) / 10;

        // The gap closes at 10/√2 m/s or more.
        assertThat(find(lower, upper, STEP, FINEST)).isEqualTo(truth, within(FINEST / 4 / 7));
    }

    /**
     * A shape that does not turn meets a disc in one point: the time does not depend on the
     * tolerance.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1e-4, 1e-6, 1e-9})
    void discIsMetAsExactlyAtAnyTolerance(double tolerance) {
        Motion floor = resting(Polygon.box(2, 1), 0, -0.5, 0);
        Motion disc = moving(new Circle(0.5), 0.3, 0.55, 2, -5);
        disc.accelerationY = -9.81;

        double truth = (Math.sqrt(25 + 2 * 9.81 * 0.05) - 5) / 9.81;

        // Coordinates are up to 1.6 m: nine roundings, 8e-15 m, at 5 m/s, and those of the truth.
        assertThat(find(floor, disc, STEP, tolerance)).isEqualTo(truth, within(1e-14));
    }

    /**
     * A box may meet with any corner: it stops in the middle of the range, at a fifth of the
     * tolerance.
     */
    @Test
    void boxIsMetAFifthOfTheToleranceBefore() {
        Motion floor = resting(Polygon.box(40, 1), 0, -0.5, 0);
        Motion box = moving(Polygon.box(1, 1), 0.3, 0.55, 0, -5);

        assertThat(gap(floor, box, find(floor, box, STEP, 1e-4))).isEqualTo(2e-5, within(1e-10));
    }

    /**
     * A corner that turns at 20 rad/s closes ever slower. A first Newton step over up to 0.05 mm
     * errs by 20²·0.7·(0.05 mm/2 m/s)²/2 = 9·10⁻⁸ m, a second one by that relative to 0.1 m,
     * squared.
     */
    @Test
    void turningBoxIsMetThereToo() {
        Motion wall = resting(Polygon.box(1, 4), 0.7 + 0.5, 0, 0);
        Motion box = resting(Polygon.box(1, 1), 0, 0, Math.toRadians(20));
        box.spin = -20;

        assertThat(gap(wall, box, find(wall, box, 0.1, 1e-3))).isEqualTo(2e-4, within(1e-12));
    }

    @Test
    void boxLandsFlat() {
        Motion floor = resting(Polygon.box(40, 1), 0, -0.5, 0);
        Motion box = moving(Polygon.box(1, 1), 0.3, 0.55, 0, -5);

        assertThat(find(floor, box, STEP, FINEST)).isEqualTo(0.01, within(FINEST / 4 / 5));
    }

    /** Multiplying sizes and speeds by one factor changes no time, to the bit. */
    @ParameterizedTest
    @ValueSource(doubles = {1.0 / 64, 64, 4096})
    void scaleDoesNotChangeTheTime(double size) {
        Motion wall = resting(Polygon.box(0.1, 2), 1, 0, 0);
        Motion box = moving(Polygon.box(0.5, 0.25), 0, 0.1, 50, 3);
        Motion scaledWall = resting(Polygon.box(0.1 * size, 2 * size), size, 0, 0);
        Motion scaledBox =
                moving(Polygon.box(0.5 * size, 0.25 * size), 0, 0.1 * size, 50 * size, 3 * size);
        box.spin = 12;
        scaledBox.spin = 12;

        double time = find(wall, box, STEP, 1e-6);

        assertThat(time).isLessThan(STEP);
        assertThat(find(scaledWall, scaledBox, STEP, 1e-6)).isEqualTo(time);
    }

    /**
     * At 10⁷ m coordinates are 2·10⁻⁹ m apart, so the stopping gap is four of these instead of a
     * share of the tolerance.
     */
    @Test
    void farFromTheOriginTheStoppingGapIsWhatCoordinatesCanTell() {
        Motion floor = resting(Polygon.box(40, 1), 1e7, -0.5, 0);
        Motion disc = moving(new Circle(0.5), 1e7 + 0.25, 0.6, 30, -10);

        double time = find(floor, disc, STEP, FINEST);

        assertThat(time).isEqualTo(0.01, within(2e-8 / 10));
        assertThat(gap(floor, disc, time)).isPositive();
    }

    @Test
    void disjointMotionsCostOneLookAtMost() {
        Motion floor = resting(Polygon.box(40, 1), 0, -0.5, 0);
        Motion disc = moving(new Circle(0.5), 3, 5, 1, -2);

        assertThat(find(floor, disc, STEP, 1e-4)).isEqualTo(TimeOfImpact.NEVER);
        assertThat(impact.evaluations).isLessThanOrEqualTo(2);
    }

    /**
     * A heptagon passes a disc at 2,900 m/s and spins at two million rad/s. Its path is 9 mm off
     * the disc's centre, twice as far as both extend. Once, each round advanced only a little,
     * however far the heptagon had gone, and the last one was reported as a hit 40 m away.
     */
    @Test
    void whatHasPassedIsNotLookedAtAnyMore() {
        Motion disc = resting(new Circle(0.004), 0.0065, 0.037, 0);
        Motion heptagon = moving(Polygon.regular(7, 7e-4), -0.019, -0.0186, 814, 2774);
        heptagon.spin = 2.1e6;

        assertThat(find(disc, heptagon, STEP, 1e-6)).isEqualTo(TimeOfImpact.NEVER);
        assertThat(impact.evaluations).isLessThan(1000);
    }
}
