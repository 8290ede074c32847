package rigibo.backend.collision.manifold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.manifold.Meeting.pose;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;

import java.util.Random;

class PolygonCircleTest {

    private static final double ROUND_OFF = 1e-15;

    private static Meeting boxAndDisc(double x, double y) {
        return new Meeting(Polygon.box(2, 1), pose(0, 0, 0), new Circle(0.25), pose(x, y, 0.7));
    }

    @Test
    void discAboveAFace() {
        Manifold manifold = boxAndDisc(0.5, 1).within(1);

        assertThat(manifold.count).isEqualTo(1);
        assertThat(manifold.separation[0]).isEqualTo(0.25);
        assertThat(manifold.normalX).isEqualTo(0);
        assertThat(manifold.normalY).isEqualTo(1);
        assertThat(manifold.source).isEqualTo(NormalSource.FACE_A);
        assertThat(manifold.pointX[0]).isEqualTo(0.5);
        assertThat(manifold.pointY[0]).isEqualTo(0.625);
    }

    /** The corner at (1, ½) and the disc's centre, on a 3-4-5 triangle. */
    @Test
    void discBesideACornerIsMeasuredFromTheCorner() {
        Manifold manifold = boxAndDisc(1.3, 0.9).within(1);

        assertThat(manifold.separation[0]).isEqualTo(0.25, within(ROUND_OFF));
        assertThat(manifold.normalX).isEqualTo(0.6, within(ROUND_OFF));
        assertThat(manifold.normalY).isEqualTo(0.8, within(ROUND_OFF));
        assertThat(manifold.source).isEqualTo(NormalSource.CLOSEST_POINTS);
        assertThat(manifold.pointX[0]).isEqualTo(1 + 0.6 * 0.125, within(ROUND_OFF));
    }

    @Test
    void discAsFirstGivesTheOppositeNormal() {
        Manifold manifold = boxAndDisc(0.5, 1).exchanged().within(1);

        assertThat(manifold.normalY).isEqualTo(-1);
        assertThat(manifold.source).isEqualTo(NormalSource.FACE_B);
        assertThat(manifold.pointY[0]).isEqualTo(0.625);
        assertThat(manifold.separation[0]).isEqualTo(0.25);
    }

    @Test
    void centreInsideLeavesByTheNearestFace() {
        Manifold manifold = boxAndDisc(0.9, 0.1).within(0);

        assertThat(manifold.normalX).isEqualTo(1);
        assertThat(manifold.separation[0]).isEqualTo(-0.1 - 0.25, within(ROUND_OFF));
        assertThat(manifold.source).isEqualTo(NormalSource.FACE_A);
    }

    @Test
    void concentricShapesHaveAnAxis() {
        Manifold manifold = boxAndDisc(0, 0).within(0);

        assertThat(manifold.separation[0]).isEqualTo(-0.75);
        assertThat(Math.abs(manifold.normalY)).isEqualTo(1);
    }

    /** The line of the face is within reach of the disc, the corner is not. */
    @Test
    void nothingBeyondReachOfACorner() {
        assertThat(boxAndDisc(1.3, 0.9).within(0.24).count).isZero();
        assertThat(boxAndDisc(1.3, 0.9).within(0.26).count).isEqualTo(1);
    }

    /** Past the end of a face the normal turns without a jump, and so does the gap. */
    @Test
    void gapAndNormalAreContinuousAroundACorner() {
        double step = 1e-9;
        Manifold before = boxAndDisc(1 - step, 0.8).within(1);
        Manifold after = boxAndDisc(1 + step, 0.8).within(1);

        assertThat(after.separation[0]).isEqualTo(before.separation[0], within(step));
        assertThat(after.normalX).isEqualTo(before.normalX, within(2 * step / 0.3));
    }

    /** For any polygon and place, the gap of a disc is that of its centre, less its radius. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void gapIsThatOfTheCentreLessTheRadius(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 5000; i++) {
            Polygon polygon = Polygon.regular(3 + random.nextInt(60), 1);
            Pose pose = pose(random.nextDouble(), 0, random.nextDouble() * 7);
            double x = random.nextDouble() * 4 - 2;
            double y = random.nextDouble() * 4 - 2;
            Meeting meeting = new Meeting(polygon, pose, new Circle(0.3), pose(x, y, 0));
            // A triangle of a picometre stands for the centre.
            double size = 1e-12;
            WorldOutline centre = new WorldOutline(Polygon.regular(3, size), pose(x, y, 0));
            double truth = WorldOutline.gap(new WorldOutline(polygon, pose), centre) - 0.3;

            meeting.within(10);

            assertThat(meeting.gap())
                    .as("seed %s, disc %s", seed, i)
                    .isEqualTo(truth, within(2 * size));
        }
    }
}
