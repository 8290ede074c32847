package rigibo.backend.collision.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.distance.Motions.any;
import static rigibo.backend.collision.distance.Motions.between;
import static rigibo.backend.collision.distance.Motions.gap;
import static rigibo.backend.collision.distance.Motions.moving;
import static rigibo.backend.collision.distance.Motions.resting;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.ImpactSearch;

import java.util.Random;

/** Impacts without a closed form, checked by dense sampling, and the number of evaluations. */
class TimeOfImpactSearchTest {

    private static final int SAMPLES = 300;

    private final TimeOfImpact impact = new TimeOfImpact();

    /**
     * A rod of 2 m turns by 80° in the step, touches a plate on the way and is clear again at the
     * end. Sampling gives the truth: the first of a million times at which the two overlap.
     */
    @ParameterizedTest
    @EnumSource(ImpactSearch.class)
    void turningRodThatIsClearAtBothEndsIsFound(ImpactSearch search) {
        Motion plate = resting(Polygon.box(10, 0.5), -5, 0, 0);
        Motion rod = resting(Polygon.box(2, 0.2), 0.5, 0, Math.toRadians(-40));
        rod.spin = Math.toRadians(80);
        assertThat(gap(plate, rod, 0)).isPositive();
        assertThat(gap(plate, rod, 1)).isPositive();

        int instant = 0;
        while (gap(plate, rod, instant * 1e-6) > 0) {
            instant++;
        }

        double time = impact.find(plate, rod, 0, 1, 1e-9, search);
        assertThat(time).isEqualTo(instant * 1e-6, within(1e-6));
        assertThat(rod.angleAt(time)).isEqualTo(-0.643, within(1e-3));
        assertThat(gap(plate, rod, time)).isPositive();
    }

    /**
     * Any two shapes, with spins up to 200 rad/s and speeds up to 1000 m/s. Before the time found,
     * the gap never falls below the stopping gap, and at that time it equals it. For a disc and a
     * shape that does not turn, the stopping gap is eight roundings of the coordinates, give or
     * take one.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void noInstantBeforeTheTimeFoundTouches(long seed) {
        Random random = new Random(seed);
        double[] tolerances = {1e-3, 1e-4, 1e-6, 1e-9};
        double[] speeds = {0.1, 1, 10, 100, 1000};
        double[] spins = {0, 1, 30, 200};
        for (int i = 0; i < 10_000; i++) {
            Motion a = any(random, speeds[random.nextInt(5)], spins[random.nextInt(4)]);
            Motion b = any(random, speeds[random.nextInt(5)], spins[random.nextInt(4)]);
            double tolerance = tolerances[random.nextInt(4)];
            double end = 1.0 / (30 + random.nextInt(200));
            if (gap(a, b, 0) > tolerance * width(a, b)) {
                check(a, b, end, tolerance, "seed " + seed + ", pair " + i);
            }
        }
    }

    /**
     * Polygons that turn many times in a step, like small ones that large ones have struck at
     * hundreds of metres a second.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void manyTurnsWithinAStepAreFollowed(long seed) {
        Random random = new Random(seed);
        double[] spins = {1_000, 3_000, 10_000};
        for (int i = 0; i < 3_000; i++) {
            Motion a = any(random, 1000, spins[random.nextInt(3)]);
            Motion b = any(random, 1000, spins[random.nextInt(3)]);
            if (gap(a, b, 0) > 1e-4) {
                check(a, b, 1.0 / 60, 1e-4, "seed " + seed + ", pair " + i);
            }
        }
    }

    /**
     * A triangle that turns 25 times within the step flies away from the corner of a hexagon. The
     * bound along its face is useless over many turns.
     */
    @Test
    void whatFliesAwayWhileItTurnsIsClearSoon() {
        Motion hexagon = resting(Polygon.regular(6, 0.7), 0, 0, 0);
        hexagon.spin = 1_270;
        Motion triangle = moving(Polygon.regular(3, 0.45), 0.93, 0, 2_500, 0);
        triangle.spin = 9_600;

        double time = impact.find(hexagon, triangle, 0, 1.0 / 60, 1e-4, ImpactSearch.ITP);
        assertThat(time).isEqualTo(TimeOfImpact.NEVER);
        assertThat(impact.evaluations).isLessThan(50);
    }

    private void check(Motion a, Motion b, double end, double tolerance, String where) {
        double time = impact.find(a, b, 0, end, tolerance, ImpactSearch.ITP);
        double scaled = tolerance * width(a, b);
        // Smallest gap that differs from none: four units in the last place.
        double rounding = 4 * Math.ulp(Math.max(farthest(a), farthest(b)));
        double least = isOfDisc(a, b) ? 7 * rounding : scaled / 8 - rounding;
        assertThat(impact.isConservative).as(where).isFalse();
        double until = Math.min(time, end);
        for (int sample = 0; sample < SAMPLES; sample++) {
            double instant = until * sample / SAMPLES;
            assertThat(gap(a, b, instant)).as("%s at %s s", where, instant).isGreaterThan(least);
        }
        if (time <= end) {
            double most = isOfDisc(a, b) ? 9 * rounding : scaled / 4 + rounding;
            assertThat(gap(a, b, time)).as(where).isBetween(least, most);
        }
    }

    /** Width of the narrower shape, with which the tolerance scales, m. */
    private static double width(Motion a, Motion b) {
        return Math.min(a.outline.smallestWidth(), b.outline.smallestWidth());
    }

    /** Whether the two meet in a single point, wherever they meet. */
    private static boolean isOfDisc(Motion a, Motion b) {
        return a.outline.isDisc() && !b.isTurning() || b.outline.isDisc() && !a.isTurning();
    }

    private static double farthest(Motion of) {
        return Math.max(Math.abs(of.x), Math.abs(of.y)) + of.outline.boundingRadius();
    }

    /**
     * Ten thousand bullets aimed at a wall all hit it, at the time of the closed form for a disc.
     */
    @Test
    void noneOfTenThousandBulletsGoesThroughAWall() {
        long seed = 40;
        Random random = new Random(seed);
        for (int i = 0; i < 10_000; i++) {
            double thickness = Math.pow(10, between(random, -3, 0));
            double speed = between(random, 50, 2000);
            double end = 1 / between(random, 30, 240);
            double start = -0.1 - between(random, 0, 1) * (speed * end - 0.2);
            Motion wall = resting(Polygon.box(thickness, 10), thickness / 2, 0, 0);
            Motion bullet = moving(new Circle(0.1), start, between(random, -4, 4), speed, 0);

            double time = impact.find(wall, bullet, 0, end, 1e-6, ImpactSearch.ITP);

            assertThat(time)
                    .as("seed %s, bullet %s", seed, i)
                    .isEqualTo((-0.1 - start) / speed, within(1e-6 / speed));
        }
    }

    /** Boxes, rods and triangles that tumble in flight all hit the wall, with whatever side. */
    @Test
    void noneOfTenThousandTumblingBulletsGoesThroughAWall() {
        long seed = 41;
        Random random = new Random(seed);
        Motion wall = resting(Polygon.box(0.001, 40), 0, 0, 0);
        for (int i = 0; i < 10_000; i++) {
            Shape shape = Motions.anyShape(random);
            double speed = between(random, 50, 2000);
            double start = -shape.boundingRadius() - between(random, 0.01, 0.5);
            Motion bullet = moving(shape, start, 0, speed, between(random, -20, 20));
            bullet.angle = between(random, 0, 7);
            bullet.spin = between(random, -200, 200);
            double end = (2 * shape.boundingRadius() + 1) / speed;

            double time = impact.find(wall, bullet, 0, end, 1e-4, ImpactSearch.ITP);

            assertThat(time).as("seed %s, bullet %s", seed, i).isLessThan(end);
            assertThat(gap(wall, bullet, time)).as("seed %s, bullet %s", seed, i).isPositive();
        }
    }

    /** Exchanging A and B changes the time by round-off only. */
    @Test
    void theOrderOfThePairDoesNotMatter() {
        long seed = 42;
        Random random = new Random(seed);
        for (int i = 0; i < 2000; i++) {
            Motion a = any(random, 100, 30);
            Motion b = any(random, 100, 30);
            double scaled = 1e-6 * width(a, b);
            if (gap(a, b, 0) > scaled) {
                double time = impact.find(a, b, 0, 0.02, 1e-6, ImpactSearch.ITP);
                double exchanged = impact.find(b, a, 0, 0.02, 1e-6, ImpactSearch.ITP);
                String where = "seed " + seed + ", pair " + i;
                assertThat(Double.isInfinite(exchanged)).as(where).isEqualTo(time > 1);
                if (time < 1) {
                    // Both searches stop in the same range of gaps; the speed converts that into
                    // time.
                    double least = isOfDisc(a, b) ? Double.MIN_VALUE : 1e-9;
                    assertThat(gap(a, b, exchanged)).as(where).isBetween(least, 0.26 * scaled);
                }
            }
        }
    }

    /**
     * From 83 mm to a range of 10⁻¹⁰ m, bisection takes some 30 evaluations; ITP takes far fewer.
     */
    @Test
    void interpolationNeedsFewLooks() {
        Motion floor = resting(Polygon.box(40, 1), 0, -0.5, 0);
        Motion disc = moving(new Circle(0.5), 3, 0.55, 1, -5);
        disc.accelerationY = -9.81;

        impact.find(floor, disc, 0, 1.0 / 60, 1e-9, ImpactSearch.ITP);
        int byInterpolation = impact.evaluations;
        impact.find(floor, disc, 0, 1.0 / 60, 1e-9, ImpactSearch.BISECTION);
        int byHalving = impact.evaluations;

        assertThat(byInterpolation).isLessThanOrEqualTo(12);
        assertThat(byHalving).isBetween(20, 40);
    }

    /**
     * Bisection takes one evaluation for a factor of 2: ten more for a tolerance 1000 times finer.
     */
    @Test
    void aFinerToleranceCostsHalvings() {
        Motion floor = resting(Polygon.box(40, 1), 0, -0.5, 0);
        Motion box = moving(Polygon.box(1, 1), 3, 0.9, 1, -50);
        box.angle = 0.3;

        impact.find(floor, box, 0, 1.0 / 60, 1e-4, ImpactSearch.BISECTION);
        int coarse = impact.evaluations;
        impact.find(floor, box, 0, 1.0 / 60, 1e-7, ImpactSearch.BISECTION);
        int fine = impact.evaluations;

        assertThat(fine - coarse).isBetween(6, 14);
    }

    /** The average over all kinds of hits; a sudden rise is a defect before it is a slow game. */
    @Test
    void looksPerHitStayFew() {
        long seed = 43;
        Random random = new Random(seed);
        int hits = 0;
        int looks = 0;
        for (int i = 0; i < 20_000; i++) {
            Motion a = any(random, 10, 5);
            Motion b = any(random, 10, 5);
            if (gap(a, b, 0) > 1e-4 && impact.find(a, b, 0, 1.0 / 60, 1e-4, ImpactSearch.ITP) < 1) {
                hits++;
                looks += impact.evaluations;
            }
        }
        assertThat(hits).as("seed %s", seed).isGreaterThan(100);
        assertThat(looks / hits).as("seed %s", seed).isLessThanOrEqualTo(14);
    }
}
