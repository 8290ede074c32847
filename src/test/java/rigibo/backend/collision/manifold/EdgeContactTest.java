package rigibo.backend.collision.manifold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Polygon;

import java.util.SplittableRandom;

/** A box on a ridge, whose top is the origin and whose flanks have any slope. */
class EdgeContactTest {

    private static final int RIGHT = 0;
    private static final int LEFT = 1;
    private static final double ROUND_OFF = 1e-12;
    private static final Polygon BOX = Polygon.box(1.2, 0.5);

    private final Collider collider = new Collider();
    private final Manifold manifold = new Manifold();

    /** The flanks are 10 m wide each. */
    private static Chain ridge(double slope) {
        return Chain.open(10, -10 * slope, 0, 0, -10, -10 * slope);
    }

    private Manifold meet(Chain ridge, int edge, Pose box) {
        collider.collide(
                ridge.outline(edge), Meeting.pose(0, 0, 0), BOX.outline(0), box, 1, manifold);
        return manifold;
    }

    /**
     * A box on the right flank, beyond the top, is behind the left flank and has no contact with
     * it.
     */
    @Test
    void nobodyIsPushedThroughARidgeBySomethingBehindIt() {
        double slope = 3;
        double length = Math.sqrt(1 + slope * slope);
        // 0.3 m down the flank; half the height of 0.5 m and a gap of 0.01 m from its surface.
        double x = (0.3 + 0.26 * slope) / length;
        double y = (-0.3 * slope + 0.26) / length;
        Pose lying = Meeting.pose(x, y, -Math.atan(slope));

        assertThat(meet(ridge(slope), RIGHT, lying).separation[0])
                .isEqualTo(0.01, within(ROUND_OFF));
        assertThat(meet(ridge(slope), LEFT, lying).count).isZero();
    }

    /** A box that does not overlap the matter under both flanks has no contact that overlaps. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.7, 1.5, 3, 8})
    void noContactOverlapsWhereNothingDoes(double slope) {
        Chain ridge = ridge(slope);
        Polygon matter = Polygon.of(-10, -10 * slope, 10, -10 * slope, 0, 0);
        SplittableRandom random = new SplittableRandom(1);
        int met = 0;
        for (int i = 0; i < 20_000; i++) {
            Pose box =
                    Meeting.pose(
                            2 * random.nextDouble() - 1,
                            2 * random.nextDouble() - 1,
                            6 * random.nextDouble());
            collider.collide(
                    matter.outline(0),
                    Meeting.pose(matter.centroidX(), matter.centroidY(), 0),
                    BOX.outline(0),
                    box,
                    1,
                    manifold);
            boolean isApart = manifold.count == 0 || least() > 0;
            if (isApart) {
                for (int edge = RIGHT; edge <= LEFT; edge++) {
                    met += meet(ridge, edge, box).count;
                    assertThat(least()).as("draw %d, edge %d", i, edge).isGreaterThan(-ROUND_OFF);
                }
            }
        }
        assertThat(met).isGreaterThan(2_000);
    }

    /**
     * A shape on one flank that has sunk in by a hair, and is turned by as little, is not pushed
     * through the ridge by the other flank. No contact overlaps by more than the shape has sunk in,
     * times √2 for the corners of a box.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.4, 0.7, 1.5, 3, 8})
    void whatHasSunkInByAHairIsNotPushedThroughTheRidge(double slope) {
        Chain ridge = ridge(slope);
        SplittableRandom random = new SplittableRandom(2);
        double flank = Math.atan(slope);
        int met = 0;
        for (int i = 0; i < 20_000; i++) {
            double sunk = 1e-3 * random.nextDouble();
            Convex lying =
                    switch (i % 3) {
                        case 0 -> new Capsule(0.1 + 0.5 * random.nextDouble(), 0.25);
                        case 1 -> Polygon.box(1.2, 0.5);
                        default -> Polygon.box(1, 0.3).rounded(0.1);
                    };
            double turn = 2e-3 * (2 * random.nextDouble() - 1);
            double along = 1.5 * random.nextDouble() - 0.5;
            double above = 0.25 - sunk;
            Pose pose =
                    Meeting.pose(
                            along * Math.cos(flank) + above * Math.sin(flank),
                            -along * Math.sin(flank) + above * Math.cos(flank),
                            turn - flank);
            // Turning lowers an end at 0.7 m by at most 0.7 · 2e-3 m.
            double most = Math.sqrt(2) * (sunk + 0.7 * Math.abs(turn));
            for (int edge = RIGHT; edge <= LEFT; edge++) {
                collider.collide(
                        ridge.outline(edge),
                        Meeting.pose(0, 0, 0),
                        lying.outline(),
                        pose,
                        1,
                        manifold);
                met += manifold.count;
                assertThat(least())
                        .as("draw %d, %s, edge %d", i, lying.kind(), edge)
                        .isGreaterThan(-most - ROUND_OFF);
            }
        }
        assertThat(met).isGreaterThan(20_000);
    }

    private double least() {
        double least = Double.POSITIVE_INFINITY;
        for (int point = 0; point < manifold.count; point++) {
            least = Math.min(least, manifold.separation[point]);
        }
        return least;
    }
}
