package rigibo.backend.collision.manifold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.manifold.Meeting.pose;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Polygon;

/** Boxes at poses where the manifold is known by hand. */
class PolygonPolygonTest {

    private static final double ROUND_OFF = 1e-15;
    private static final Polygon BOX = Polygon.box(1, 1);
    private static final Polygon FLOOR = Polygon.box(40, 1);

    private static Meeting onFloor(double x, double height, double angle) {
        return new Meeting(FLOOR, pose(0, -0.5, 0), BOX, pose(x, height + 0.5, angle));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.01, 0.01})
    void boxOnAFloorHasTwoPoints(double height) {
        Manifold manifold = onFloor(3, height, 0).within(0.1);

        assertThat(manifold.count).isEqualTo(2);
        assertThat(manifold.normalX).isEqualTo(0);
        assertThat(manifold.normalY).isEqualTo(1);
        assertThat(manifold.source).isEqualTo(NormalSource.FACE_A);
        assertThat(manifold.separation)
                .containsExactly(new double[] {height, height}, within(ROUND_OFF));
        assertThat(manifold.pointX).containsExactlyInAnyOrder(2.5, 3.5);
        assertThat(manifold.pointY)
                .containsExactly(new double[] {height / 2, height / 2}, within(ROUND_OFF));
    }

    /**
     * A resting box keeps its two points and their features when it turns by a billionth of a
     * radian.
     */
    @Test
    void featuresOfARestingBoxStay() {
        Manifold rest = onFloor(3, 0, 0).within(0.1);
        int[] names = rest.feature.clone();
        for (double angle : new double[] {1e-9, -1e-9, 1e-4, -1e-4}) {
            for (double height : new double[] {-1e-6, 0, 1e-6}) {
                Manifold manifold = onFloor(3 + angle, height, angle).within(0.1);
                assertThat(manifold.count).isEqualTo(2);
                assertThat(manifold.feature).isEqualTo(names);
            }
        }
    }

    /** Corner over corner: round-off decides which of the two lies inside, but not the feature. */
    @Test
    void featuresOfEqualBoxesOnEachOtherStay() {
        Meeting rest = new Meeting(BOX, pose(0, 0, 0), BOX, pose(0, 1, 0));
        int[] names = rest.within(0.1).feature.clone();
        NormalSource source = rest.manifold.source;
        for (double shift : new double[] {1e-9, -1e-9, 1e-4, -1e-4}) {
            for (double angle : new double[] {1e-6, -1e-6, 0}) {
                Meeting moved = new Meeting(BOX, pose(0, 0, 0), BOX, pose(shift, 1, angle));
                Manifold manifold = moved.within(0.1);
                assertThat(manifold.count).isEqualTo(2);
                assertThat(manifold.feature).isEqualTo(names);
                assertThat(manifold.source).isEqualTo(source);
            }
        }
    }

    /** A box that rolls over its lower right corner keeps the feature of that corner. */
    @Test
    void cornerKeepsItsNameWhileABoxRollsOverIt() {
        Integer name = null;
        for (double angle = -0.2; angle > -1.4; angle -= 0.1) {
            double height = Math.sqrt(0.5) * Math.sin(Math.PI / 4 - angle) - 0.5;
            Manifold manifold = onFloor(0, height, angle).within(0.01);
            assertThat(manifold.count).as("angle %s", angle).isEqualTo(1);
            assertThat(manifold.separation[0]).isEqualTo(0, within(ROUND_OFF));
            if (name != null) {
                assertThat(manifold.feature[0]).as("angle %s", angle).isEqualTo(name);
            }
            name = manifold.feature[0];
        }
    }

    /** The lower box's right end clips the upper box's lower edge at x = ½. */
    @Test
    void overhangIsCutAtTheEndOfTheFace() {
        Manifold manifold = new Meeting(BOX, pose(0, 0, 0), BOX, pose(0.7, 1, 0)).within(0.1);

        assertThat(manifold.pointX).containsExactly(new double[] {0.5, 0.2}, within(ROUND_OFF));
    }

    /** Corners (½, ½) and (0.8, 0.9), on a 3-4-5 triangle. */
    @Test
    void twoCornersAreMeasuredAlongTheLineBetweenThem() {
        Manifold manifold = new Meeting(BOX, pose(0, 0, 0), BOX, pose(1.3, 1.4, 0)).within(1);

        assertThat(manifold.count).isEqualTo(1);
        assertThat(manifold.separation[0]).isEqualTo(0.5, within(ROUND_OFF));
        assertThat(manifold.normalX).isEqualTo(0.6, within(ROUND_OFF));
        assertThat(manifold.normalY).isEqualTo(0.8, within(ROUND_OFF));
        assertThat(manifold.source).isEqualTo(NormalSource.CLOSEST_POINTS);
        assertThat(manifold.pointX[0]).isEqualTo(0.65, within(ROUND_OFF));
        assertThat(manifold.pointY[0]).isEqualTo(0.7, within(ROUND_OFF));
    }

    /**
     * Boxes that touch with any two corners touch exactly there, though faces in one line are as
     * near along all of their length.
     */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, -1", "-1, 1", "-1, -1"})
    void boxesThatTouchInACornerTouchThere(double x, double y) {
        Manifold manifold = new Meeting(BOX, pose(0, 0, 0), BOX, pose(x, y, 0)).within(0.1);

        assertThat(manifold.count).isOne();
        assertThat(manifold.separation[0]).isZero();
        assertThat(manifold.pointX[0]).isEqualTo(x / 2);
        assertThat(manifold.pointY[0]).isEqualTo(y / 2);
    }

    /** The faces' lines are 0.3 m and 0.4 m away, the corners half a metre. */
    @Test
    void nothingBeyondReachOfTwoCorners() {
        Meeting corners = new Meeting(BOX, pose(0, 0, 0), BOX, pose(1.3, 1.4, 0));

        assertThat(corners.within(0.49).count).isZero();
        assertThat(corners.within(0.51).count).isEqualTo(1);
    }

    @Test
    void boxOnItsCornerHasOnePoint() {
        Manifold manifold = onFloor(0, Math.sqrt(0.5) - 0.5 + 0.01, Math.PI / 4).within(0.1);

        assertThat(manifold.count).isEqualTo(1);
        assertThat(manifold.separation[0]).isEqualTo(0.01, within(ROUND_OFF));
        assertThat(manifold.pointX[0]).isEqualTo(0, within(ROUND_OFF));
    }

    /** The smaller box is deeper inside than its width and leaves by the nearest face. */
    @Test
    void boxInsideABoxLeavesByTheNearestFace() {
        Meeting inside = new Meeting(FLOOR, pose(0, 0, 0), Polygon.box(0.1, 0.1), pose(1, 0.1, 0));

        Manifold manifold = inside.within(0);

        assertThat(manifold.normalY).isEqualTo(1);
        assertThat(inside.gap()).isEqualTo(-(0.5 - 0.1 + 0.05), within(ROUND_OFF));
    }

    @Test
    void concentricBoxesHaveAnAxis() {
        Meeting concentric = new Meeting(BOX, pose(0, 0, 0), BOX, pose(0, 0, 0));

        Manifold manifold = concentric.within(0);

        assertThat(concentric.gap()).isEqualTo(-1);
        assertThat(Math.hypot(manifold.normalX, manifold.normalY)).isEqualTo(1);
    }

    /** A floor of 10⁶ m keeps its height exactly under a box at any angle. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aWideFloorStaysFlat(boolean isFloorFirst) {
        Polygon wide = Polygon.box(2e6, 1);
        for (int i = 0; i < 100; i++) {
            double angle = i * 0.07;
            double halfHeight = (Math.abs(Math.cos(angle)) + Math.abs(Math.sin(angle))) / 2;
            Meeting meeting =
                    new Meeting(wide, pose(1e5, -0.5, 0), BOX, pose(3.3 * i, halfHeight, angle));
            Meeting ordered = isFloorFirst ? meeting : meeting.exchanged();

            Manifold manifold = ordered.within(0.01);

            assertThat(ordered.gap()).as("angle %s", angle).isEqualTo(0, within(5e-16));
            assertThat(Math.abs(manifold.normalY)).isEqualTo(1);
            assertThat(manifold.normalX).isZero();
        }
    }
}
