package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.collision.distance.PointAndRay;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.Optional;
import java.util.Random;

/** A ray finds what asking every body finds, to the bit, at a cost that goes with its way. */
class RayCastTest {

    private static final int RAYS = 500;

    /** Discs of a grid have this radius and stand 1 m apart, m. */
    private static final double RADIUS = 0.2;

    private final Pool pool = new Pool();

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void hitIsThatOfAskingEveryBodyToTheBit(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 300; i++) {
            addAny(random);
        }
        Scenes.run(pool, 20);
        for (int i = 0; i < 100; i++) {
            pool.remove(pool.bodies().get(random.nextInt(pool.bodies().size())));
            addAny(random);
        }
        int met = 0;
        for (int i = 0; i < RAYS; i++) {
            // Short ones, and some from a hundred kilometres away.
            double far = i % 5 == 0 ? 1e5 : 30;
            double[] ray = new double[4];
            for (int k = 0; k < 4; k++) {
                ray[k] = (k < 2 ? far : 20) * (random.nextDouble() - 0.5);
            }
            Optional<RayHit> expected = ofEveryBody(ray);
            assertThat(pool.rayCast(ray[0], ray[1], ray[2], ray[3]))
                    .as("ray %d, seed %d", i, seed)
                    .isEqualTo(expected);
            met += expected.isPresent() ? 1 : 0;
        }
        assertThat(met).isBetween(RAYS / 5, RAYS - 1);
    }

    private void addAny(Random random) {
        double size = 0.1 + random.nextDouble() * (random.nextInt(50) == 0 ? 5 : 0.5);
        BodyDefinition body =
                BodyDefinition.dynamic(
                        random.nextBoolean() ? new Circle(size) : Polygon.box(size, 2 * size));
        if (random.nextInt(4) == 0) {
            body = BodyDefinition.fixed(body.shape());
        }
        pool.add(
                body.at(20 * random.nextDouble() - 10, 20 * random.nextDouble() - 10)
                        .angle(random.nextInt(2) * random.nextDouble()));
    }

    /** In the order they were added, so that the first of several at one point stays. */
    private Optional<RayHit> ofEveryBody(double[] ray) {
        PointAndRay asked = new PointAndRay();
        Pose pose = new Pose();
        RayHit first = null;
        for (RigidBody body : pool.bodies()) {
            int slot = body.slot();
            pose.set(body.x(), body.y(), pool.columns().cos[slot], pool.columns().sin[slot]);
            double at = asked.enters(body.shape().outline(0), pose, ray[0], ray[1], ray[2], ray[3]);
            if (at <= 1 && (first == null || at < first.fraction())) {
                double x = ray[0] + at * (ray[2] - ray[0]);
                double y = ray[1] + at * (ray[3] - ray[1]);
                first = new RayHit(body, 0, x, y, asked.normalX, asked.normalY, at);
            }
        }
        return Optional.ofNullable(first);
    }

    /** Slots are used again: the body in the lower one was added later. */
    @Test
    void ofTwoInOnePlaceTheFirstAddedIsMet() {
        BodyDefinition disc = BodyDefinition.fixed(new Circle(1));
        RigidBody low = pool.add(disc);
        RigidBody first = pool.add(disc);
        pool.remove(low);
        RigidBody second = pool.add(disc);
        assertThat(second.slot()).isLessThan(first.slot());
        assertThat(pool.rayCast(-5, 0.5, 5, 0.5).orElseThrow().body()).isSameAs(first);
        assertThat(pool.bodyAt(0, 0)).contains(second);
    }

    /** The first row stops every ray: no more than the way down the tree, and some beside it. */
    @Test
    void rayThatIsStoppedAtOnceAsksFewOfTenThousand() {
        grid(100);
        assertThat(pool.rayCast(-1, -1, 100, 100)).isPresent();
        assertThat(work().shapes()).isLessThanOrEqualTo(3);
        assertThat(work().nodes()).isLessThan(100);
    }

    /**
     * Between the discs of a grid, from corner to corner. The ray passes two cells per column; a
     * leaf's box of 0.44 m at most reaches 0.44/√2 = 0.31 m from a disc's centre towards a ray that
     * passes it at 0.5/√2 = 0.35 m, so that no shape is asked. Every cell it passes costs the nodes
     * in which its leaf is told from its neighbours; a box spanned by the ray would hold them all.
     */
    @Test
    void costOfADiagonalRayGrowsWithItsLength() {
        grid(50);
        assertThat(pool.rayCast(-1, -1.5, 50, 49.5)).isEmpty();
        int nodesOfFifty = work().nodes();
        assertThat(work().shapes()).isZero();
        grid(100);
        assertThat(pool.rayCast(-1, -1.5, 100, 99.5)).isEmpty();
        assertThat(work().shapes()).isZero();
        assertThat(work().nodes()).isBetween(200, 3 * nodesOfFifty);
        assertThat(work().nodes()).isLessThan(100 * 100 / 4);
    }

    private RayCast work() {
        return pool.queries().ray();
    }

    /** Adds what is missing of a square of so many discs a side. */
    private void grid(int side) {
        int there = (int) Math.sqrt(pool.bodies().size());
        for (int i = 0; i < side * side; i++) {
            int x = i % side;
            int y = i / side;
            if (x >= there || y >= there) {
                pool.add(BodyDefinition.dynamic(new Circle(RADIUS)).at(x, y));
            }
        }
    }
}
