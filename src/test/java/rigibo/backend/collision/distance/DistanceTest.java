package rigibo.backend.collision.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.distance.Motions.between;
import static rigibo.backend.collision.manifold.Meeting.pose;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.collision.manifold.WorldOutline;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;

import java.util.Random;

class DistanceTest {

    private static final double ROUND_OFF = 1e-14;

    private final Distance distance = new Distance();

    /** The corner (½, ½) and a disc's centre, on a 3-4-5 triangle. */
    @Test
    void witnessPointsLieOnBothOutlines() {
        double gap =
                distance.measure(
                        Polygon.box(1, 1).outline(),
                        pose(0, 0, 0),
                        new Circle(0.25).outline(),
                        pose(0.8, 0.9, 0));

        assertThat(gap).isEqualTo(0.25, within(ROUND_OFF));
        assertThat(distance.pointAX).isEqualTo(0.5, within(ROUND_OFF));
        assertThat(distance.pointAY).isEqualTo(0.5, within(ROUND_OFF));
        assertThat(distance.pointBX).isEqualTo(0.8 - 0.6 * 0.25, within(ROUND_OFF));
        assertThat(distance.pointBY).isEqualTo(0.9 - 0.8 * 0.25, within(ROUND_OFF));
    }

    /** Distances have no bias, however nearly parallel two faces are and in either order. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void distanceIsExactWhereFacesAreNearlyParallel(long seed) {
        Random random = new Random(seed);
        Polygon box = Polygon.box(1, 1);
        for (int i = 0; i < 5000; i++) {
            Pose low = pose(0, 0, 0);
            double tilt = between(random, -2e-4, 2e-4);
            Pose high = pose(between(random, -1.5, 1.5), between(random, 1.0002, 1.001), tilt);
            double truth =
                    WorldOutline.gap(new WorldOutline(box, low), new WorldOutline(box, high));

            assertThat(distance.measure(box.outline(), low, box.outline(), high))
                    .as("seed %s, pair %s", seed, i)
                    .isEqualTo(truth, within(ROUND_OFF));
            assertThat(distance.measure(box.outline(), high, box.outline(), low))
                    .as("seed %s, pair %s", seed, i)
                    .isEqualTo(truth, within(ROUND_OFF));
        }
    }

    /**
     * Polygons of hundreds of short edges, where a search from corner to corner must not stop too
     * soon.
     */
    @ParameterizedTest
    @ValueSource(longs = {3, 4})
    void distanceOfManySidedPolygonsIsExact(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 200; i++) {
            Polygon a = Polygon.regular(3 + random.nextInt(254), between(random, 0.1, 1));
            Polygon b = Polygon.regular(3 + random.nextInt(254), between(random, 0.1, 1));
            Pose poseA = pose(0, 0, between(random, 0, 7));
            Pose poseB = pose(between(random, -2, 2), between(random, -2, 2), i);
            double truth = WorldOutline.gap(new WorldOutline(a, poseA), new WorldOutline(b, poseB));

            assertThat(distance.measure(a.outline(), poseA, b.outline(), poseB))
                    .as("seed %s, pair %s", seed, i)
                    .isEqualTo(truth, within(ROUND_OFF));
        }
    }

    /** A sliver of 1:10⁴ against another, in any position. */
    @Test
    void sliversAreMeasuredAsExactly() {
        long seed = 5;
        Random random = new Random(seed);
        Polygon sliver = Polygon.box(2, 2e-4);
        for (int i = 0; i < 5000; i++) {
            Pose poseA = pose(0, 0, between(random, 0, 7));
            Pose poseB = pose(between(random, -1, 1), between(random, -1, 1), i);
            double truth =
                    WorldOutline.gap(
                            new WorldOutline(sliver, poseA), new WorldOutline(sliver, poseB));

            assertThat(distance.measure(sliver.outline(), poseA, sliver.outline(), poseB))
                    .as("seed %s, pair %s", seed, i)
                    .isEqualTo(truth, within(ROUND_OFF));
        }
    }

    /**
     * Any two polygons, moved along the axis between them until they nearly touch or barely
     * overlap. Where corners pass each other, a face is easily mistaken for the nearest feature.
     */
    @ParameterizedTest
    @ValueSource(longs = {6, 7, 8})
    void gapIsExactWherePolygonsNearlyTouch(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 20_000; i++) {
            Polygon a = anyPolygon(random);
            Polygon b = anyPolygon(random);
            Pose poseA = pose(0, 0, between(random, 0, 7));
            Pose poseB = pose(between(random, -3, 3), between(random, -3, 3), i);
            double gap = distance.measure(a.outline(), poseA, b.outline(), poseB);
            double rest = Math.pow(10, between(random, -6, -1)) * (random.nextBoolean() ? 1 : -1);
            poseB.x -= (gap - rest) * distance.axisX;
            poseB.y -= (gap - rest) * distance.axisY;
            double truth = WorldOutline.gap(new WorldOutline(a, poseA), new WorldOutline(b, poseB));

            assertThat(distance.measure(a.outline(), poseA, b.outline(), poseB))
                    .as("seed %s, pair %s", seed, i)
                    .isEqualTo(truth, within(ROUND_OFF));
        }
    }

    private static Polygon anyPolygon(Random random) {
        return switch (random.nextInt(4)) {
            case 0 -> Polygon.box(between(random, 0.05, 2), between(random, 0.05, 1));
            case 1 -> Polygon.of(0, 0, between(random, 1, 2), between(random, 0, 0.5), 0.3, 1);
            case 2 -> Polygon.of(0, 0, 2, -0.02, 2, between(random, 0, 0.3));
            default -> Polygon.regular(3 + random.nextInt(20), between(random, 0.2, 1));
        };
    }
}
