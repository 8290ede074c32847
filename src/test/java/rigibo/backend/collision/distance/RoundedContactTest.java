package rigibo.backend.collision.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.distance.Motions.between;
import static rigibo.backend.collision.distance.Motions.moving;
import static rigibo.backend.collision.distance.Motions.resting;
import static rigibo.backend.collision.manifold.Meeting.pose;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.collision.manifold.Meeting;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.ImpactSearch;

import java.util.Random;

/** Contacts of shapes with round corners, compared with closed forms. */
class RoundedContactTest {

    private static final double ROUND_OFF = 1e-14;

    private final Capsule capsule = new Capsule(0.5, 0.2);

    /** End to end, no face separates the cores, whose distance is 1.5 − 2·½; the gap is 0.1 m. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, 1, Math.PI / 2, 2.5, Math.PI})
    void capsulesInOneLineMeetEndToEnd(double angle) {
        Meeting meeting =
                new Meeting(
                        capsule,
                        pose(0, 0, angle),
                        capsule,
                        pose(1.5 * Math.cos(angle), 1.5 * Math.sin(angle), angle));

        Manifold manifold = meeting.within(1);

        assertThat(manifold.count).isEqualTo(1);
        assertThat(manifold.separation[0]).isEqualTo(0.1, within(ROUND_OFF));
        assertThat(manifold.normalX).isEqualTo(Math.cos(angle), within(ROUND_OFF));
        assertThat(manifold.normalY).isEqualTo(Math.sin(angle), within(ROUND_OFF));
        assertThat(manifold.pointX[0]).isEqualTo(0.75 * Math.cos(angle), within(ROUND_OFF));
    }

    /**
     * Two capsules nearly side by side, nearest at their left ends. The right end will land when
     * they turn, so it is a point as well: its gap is its height over the other's core, less both
     * radii. The two cores' heights differ by the cosine of the angle between them.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.08, 0.12, 0.2})
    void endsThatAreNearestDoNotHideTheOthers(double tilt) {
        double x = -0.03;
        double y = 0.42 + 0.5 * Math.sin(tilt);
        Meeting meeting = new Meeting(capsule, pose(0, 0, 0), capsule, pose(x, y, tilt));

        Manifold manifold = meeting.within(1);

        double left = Math.hypot(x - 0.5 * Math.cos(tilt) + 0.5, y - 0.5 * Math.sin(tilt)) - 0.4;
        double right = y + 0.5 * Math.sin(tilt) - 0.4;
        double either = (1 - Math.cos(tilt)) * (right + 0.4);
        assertThat(manifold.count).isEqualTo(2);
        int first = manifold.pointX[0] < 0 ? 0 : 1;
        assertThat(manifold.separation[first]).isEqualTo(left, within(ROUND_OFF));
        assertThat(manifold.separation[1 - first]).isEqualTo(right, within(either + ROUND_OFF));
        assertThat(manifold.pointX[1 - first]).isGreaterThan(0.4);
    }

    @Test
    void aDiscAtTheEndOfACapsuleIsNotInsideOfIt() {
        Meeting meeting = new Meeting(capsule, pose(0, 0, 0), new Circle(0.25), pose(1, 0, 0));

        assertThat(meeting.within(1).separation[0]).isEqualTo(0.05, within(ROUND_OFF));
        assertThat(meeting.manifold.normalX).isEqualTo(1);
    }

    /** A lying capsule stands on both ends of its core; an upright one, on one end. */
    @Test
    void aCapsuleLiesOnTwoPointsAndStandsOnOne() {
        Polygon floor = Polygon.box(10, 1);
        Meeting lying = new Meeting(floor, pose(0, -0.5, 0), capsule, pose(0.1, 0.2, 0));
        Meeting standing =
                new Meeting(floor, pose(0, -0.5, 0), capsule, pose(0.1, 0.7, Math.PI / 2));

        Manifold two = lying.within(0.01);
        Manifold one = standing.within(0.01);

        assertThat(two.count).isEqualTo(2);
        assertThat(two.pointX[0] + two.pointX[1]).isEqualTo(0.2, within(ROUND_OFF));
        assertThat(Math.abs(two.pointX[0] - two.pointX[1])).isEqualTo(1, within(ROUND_OFF));
        assertThat(two.separation[0]).isEqualTo(0, within(ROUND_OFF));
        assertThat(two.pointY[0]).isEqualTo(0, within(ROUND_OFF));
        assertThat(one.count).isEqualTo(1);
        assertThat(one.pointX[0]).isEqualTo(0.1, within(ROUND_OFF));
        assertThat(one.separation[0]).isEqualTo(0, within(ROUND_OFF));
    }

    /** Equal shapes give equal bits. */
    @Test
    void aCapsuleWithoutLengthIsADisc() {
        Random random = new Random(1);
        for (int i = 0; i < 1000; i++) {
            double radius = between(random, 0.1, 1);
            Shape other = Motions.anyShape(random);
            Pose here = pose(between(random, -1, 1), between(random, -1, 1), between(random, 0, 7));
            Pose there = pose(between(random, -1, 1), 0, between(random, 0, 7));
            Manifold disc = new Meeting(new Circle(radius), here, other, there).within(1);
            Manifold pill = new Meeting(new Capsule(0, radius), here, other, there).within(1);

            assertThat(pill.count).isEqualTo(disc.count);
            for (int point = 0; point < disc.count; point++) {
                assertThat(pill.pointX[point]).isEqualTo(disc.pointX[point]);
                assertThat(pill.separation[point]).isEqualTo(disc.separation[point]);
            }
        }
    }

    /**
     * A capsule turns at ω above a floor. The lower end is at the height y − h·sin(ωt) − r, so it
     * touches when sin(ωt) = (y − r)/h.
     */
    @Test
    void aTurningCapsuleTouchesTheFloorInTime() {
        Motion floor = resting(Polygon.box(10, 1), 0, -0.5, 0);
        Motion turning = moving(capsule, 0, 0.6, 0, 0);
        turning.spin = 3;
        double truth = Math.asin(0.4 / 0.5) / 3;

        double time = new TimeOfImpact().find(floor, turning, 0, 2, 1e-9, ImpactSearch.ITP);

        assertThat(time).isEqualTo(truth, within(1e-9));
    }

    /** Squares corner to corner: the cores' distance √2·(1 − ½ − ½), less both radii. */
    @Test
    void roundCornersAreNearerThanTheirCores() {
        Polygon square = Polygon.box(1, 1).rounded(0.1);
        Meeting meeting = new Meeting(square, pose(0, 0, 0), square, pose(1.5, 1.5, 0));

        Manifold manifold = meeting.within(1);

        assertThat(manifold.count).isEqualTo(1);
        assertThat(manifold.separation[0]).isEqualTo(Math.sqrt(0.5) - 0.2, within(ROUND_OFF));
        assertThat(manifold.normalX).isEqualTo(Math.sqrt(0.5), within(ROUND_OFF));
    }
}
