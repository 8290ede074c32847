package rigibo.backend.collision.manifold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.backend.collision.distance.Motions.anyShape;
import static rigibo.backend.collision.distance.Motions.anyShapeWithEdges;
import static rigibo.backend.collision.distance.Motions.between;
import static rigibo.backend.collision.manifold.Meeting.pose;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Allocation;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

import java.util.Random;

/** Laws of the manifold of any two shapes. */
class ManifoldLawsTest {

    private static final int MEETINGS = 5000;

    private static Meeting any(Random random) {
        return new Meeting(anyShape(random), anyPose(random), anyShape(random), anyPose(random));
    }

    /**
     * A random pose; some angles are multiples of 45°, where edges are parallel or corners face
     * each other.
     */
    private static Pose anyPose(Random random) {
        double angle =
                random.nextInt(3) == 0 ? Math.PI / 4 * random.nextInt(8) : between(random, 0, 7);
        return pose(between(random, -1, 1), between(random, -1, 1), angle);
    }

    /**
     * The gap equals that of a search of all features, also in overlap, where the shortest way out
     * is along a face's normal. Nearly parallel faces may differ by the bias towards A's, a
     * ten-thousandth of the width.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void gapIsTheDistance(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < MEETINGS; i++) {
            Shape a = anyShapeWithEdges(random);
            Shape b = anyShapeWithEdges(random);
            Meeting meeting = new Meeting(a, anyPose(random), b, anyPose(random));
            double truth =
                    WorldOutline.gap(
                            new WorldOutline(a, meeting.poseA), new WorldOutline(b, meeting.poseB));
            double reach = between(random, 0, 2);
            double bias = 1e-4 * Math.min(a.smallestWidth(), b.smallestWidth());
            String where = "seed " + seed + ", meeting " + i;

            Manifold manifold = meeting.within(reach);

            if (manifold.count == 0) {
                assertThat(truth).as(where).isGreaterThan(reach - 1e-12);
            } else {
                assertThat(meeting.gap()).as(where).isEqualTo(truth, within(bias));
            }
        }
    }

    /** Along the normal, no point of A is beyond B by more than the gap allows. */
    @ParameterizedTest
    @ValueSource(longs = {4, 5})
    void normalSeparatesTheShapes(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < MEETINGS; i++) {
            Meeting meeting = any(random);
            Manifold manifold = meeting.within(10);
            double along =
                    manifold.normalX * (meeting.poseB.x - meeting.poseA.x)
                            + manifold.normalY * (meeting.poseB.y - meeting.poseA.y);
            double between =
                    along
                            - reach(meeting.a, meeting.poseA, manifold, 1)
                            - reach(meeting.b, meeting.poseB, manifold, -1);
            String where = "seed " + seed + ", meeting " + i;

            assertThat(Math.hypot(manifold.normalX, manifold.normalY))
                    .as(where)
                    .isEqualTo(1, within(1e-14));
            assertThat(between).as(where).isEqualTo(meeting.gap(), within(2e-4));
        }
    }

    private static double reach(Shape shape, Pose pose, Manifold manifold, int sign) {
        if (shape instanceof Circle) {
            return shape.boundingRadius();
        }
        Pose turned = new Pose();
        turned.set(0, 0, pose.cos, pose.sin);
        return new WorldOutline(shape, turned)
                .reach(sign * manifold.normalX, sign * manifold.normalY);
    }

    /**
     * Exchanging A and B gives the same gap and, where a single axis is shortest, the opposite
     * normal. Of parallel faces A's is taken, up to a hundredth of a radian from B's.
     */
    @ParameterizedTest
    @ValueSource(longs = {6, 7})
    void exchangingTheShapesTurnsTheNormal(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < MEETINGS; i++) {
            Meeting meeting = any(random);
            Meeting exchanged = meeting.exchanged();
            Manifold one = meeting.within(10);
            Manifold other = exchanged.within(10);
            String where = "seed " + seed + ", meeting " + i;

            assertThat(exchanged.gap()).as(where).isEqualTo(meeting.gap(), within(2e-4));
            if (meeting.gap() > 0.001) {
                assertThat(other.normalX).as(where).isEqualTo(-one.normalX, within(1.1e-2));
                assertThat(other.normalY).as(where).isEqualTo(-one.normalY, within(1.1e-2));
            }
        }
    }

    /** At 1/64 of the size every length is 1/64, to the bit. */
    @Test
    void scaleChangesLengthsAlone() {
        long seed = 8;
        Random random = new Random(seed);
        double size = 1.0 / 64;
        for (int i = 0; i < MEETINGS; i++) {
            Meeting meeting = any(random);
            Meeting small =
                    new Meeting(
                            scaled(meeting.a, size),
                            scaled(meeting.poseA, size),
                            scaled(meeting.b, size),
                            scaled(meeting.poseB, size));
            Manifold large = meeting.within(0.5);
            Manifold tiny = small.within(0.5 * size);
            String where = "seed " + seed + ", meeting " + i;

            assertThat(tiny.count).as(where).isEqualTo(large.count);
            for (int point = 0; point < large.count; point++) {
                assertThat(tiny.separation[point])
                        .as(where)
                        .isEqualTo(large.separation[point] * size);
                assertThat(tiny.pointX[point]).as(where).isEqualTo(large.pointX[point] * size);
                assertThat(tiny.feature[point]).as(where).isEqualTo(large.feature[point]);
                assertThat(tiny.normalX).as(where).isEqualTo(large.normalX);
            }
        }
    }

    private static Shape scaled(Shape shape, double size) {
        if (shape instanceof Circle) {
            return new Circle(shape.boundingRadius() * size);
        }
        if (shape instanceof Capsule capsule) {
            return new Capsule(capsule.halfLength() * size, capsule.radius() * size);
        }
        Polygon polygon = (Polygon) shape;
        double[] xy = new double[2 * polygon.corners()];
        for (int i = 0; i < polygon.corners(); i++) {
            xy[2 * i] = polygon.cornerX(i) * size;
            xy[2 * i + 1] = polygon.cornerY(i) * size;
        }
        return Polygon.of(xy).rounded(polygon.radius() * size);
    }

    private static Pose scaled(Pose pose, double size) {
        Pose scaled = new Pose();
        scaled.set(pose.x * size, pose.y * size, pose.cos, pose.sin);
        return scaled;
    }

    /** Boxes mirrored at the y axis give the mirrored manifold, to the bit. */
    @Test
    void mirrorImageIsExact() {
        long seed = 9;
        Random random = new Random(seed);
        for (int i = 0; i < MEETINGS; i++) {
            Polygon a = Polygon.box(between(random, 0.5, 2), between(random, 0.5, 2));
            Polygon b = Polygon.box(between(random, 0.5, 2), between(random, 0.5, 2));
            Meeting meeting = new Meeting(a, anyPose(random), b, anyPose(random));
            Meeting mirrored = new Meeting(a, mirrored(meeting.poseA), b, mirrored(meeting.poseB));
            Manifold one = meeting.within(0.2);
            Manifold other = mirrored.within(0.2);
            String where = "seed " + seed + ", meeting " + i;

            assertThat(other.count).as(where).isEqualTo(one.count);
            if (one.count > 0) {
                assertThat(other.normalX).as(where).isEqualTo(0.0 - one.normalX);
                assertThat(other.normalY).as(where).isEqualTo(one.normalY);
                assertThat(mirrored.gap()).as(where).isEqualTo(meeting.gap());
            }
            for (int point = 0; point < one.count; point++) {
                int twin = one.count - 1 - point;
                assertThat(other.pointX[twin]).as(where).isEqualTo(0.0 - one.pointX[point]);
                assertThat(other.pointY[twin]).as(where).isEqualTo(one.pointY[point]);
                assertThat(other.separation[twin]).as(where).isEqualTo(one.separation[point]);
            }
        }
    }

    private static Pose mirrored(Pose pose) {
        Pose mirrored = new Pose();
        mirrored.set(-pose.x, pose.y, pose.cos, -pose.sin);
        return mirrored;
    }

    /** At 10⁹ m coordinates are 1.2·10⁻⁷ m apart; poses on such coordinates lose nothing. */
    @Test
    void farFromTheOriginTheManifoldIsTheSame() {
        long seed = 10;
        Random random = new Random(seed);
        double grid = 1.0 / (1 << 22);
        for (int i = 0; i < MEETINGS; i++) {
            Meeting near = any(random);
            near.poseA.x = Math.rint(near.poseA.x / grid) * grid;
            near.poseB.x = Math.rint(near.poseB.x / grid) * grid;
            Pose farA = pose(0, 0, 0);
            Pose farB = pose(0, 0, 0);
            farA.set(near.poseA.x + 1e9, near.poseA.y, near.poseA.cos, near.poseA.sin);
            farB.set(near.poseB.x + 1e9, near.poseB.y, near.poseB.cos, near.poseB.sin);
            Meeting far = new Meeting(near.a, farA, near.b, farB);
            Manifold one = near.within(0.5);
            Manifold other = far.within(0.5);
            String where = "seed " + seed + ", meeting " + i;

            assertThat(other.count).as(where).isEqualTo(one.count);
            for (int point = 0; point < one.count; point++) {
                assertThat(other.separation[point]).as(where).isEqualTo(one.separation[point]);
                assertThat(other.normalX).as(where).isEqualTo(one.normalX);
            }
        }
    }

    @Test
    void nothingIsAllocated() {
        Random random = new Random(11);
        Meeting[] meetings = new Meeting[500];
        Outline[][] outlines = new Outline[meetings.length][];
        for (int i = 0; i < meetings.length; i++) {
            meetings[i] = any(random);
            outlines[i] = new Outline[] {meetings[i].a.outline(0), meetings[i].b.outline(0)};
        }
        Collider collider = new Collider();
        Manifold manifold = new Manifold();

        long bytes =
                Allocation.ofThirdRun(
                        () -> {
                            for (int i = 0; i < meetings.length; i++) {
                                Meeting m = meetings[i];
                                Outline a = outlines[i][0];
                                Outline b = outlines[i][1];
                                collider.collide(a, m.poseA, b, m.poseB, 0.5, manifold);
                            }
                        });

        assertThat(bytes).isZero();
    }
}
