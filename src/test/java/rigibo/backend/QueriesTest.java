package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** Queries answer what brute force over every body answers. */
class QueriesTest {

    private static final int COUNT = 2000;
    private static final long SEED = 7;

    /** A point so near to an outline may count as inside or outside. */
    private static final double ON_THE_EDGE = 1e-9;

    private final Random random = new Random(SEED);
    private Pool pool;

    @BeforeEach
    void tumble() {
        pool = Scenes.MIXTURE.build();
        Scenes.run(pool, 90);
    }

    @Test
    void sizeFixtureHoldsTheBody() {
        Aabb fixture = new Aabb();
        Aabb bounds = new Aabb();
        for (RigidBody body : pool.bodies()) {
            body.sizeFixture(fixture);
            double angle = body.angle();
            body.shape().bounds(body.x(), body.y(), Math.cos(angle), Math.sin(angle), bounds);
            assertThat(fixture.minX).isLessThanOrEqualTo(bounds.minX + ON_THE_EDGE);
            assertThat(fixture.minY).isLessThanOrEqualTo(bounds.minY + ON_THE_EDGE);
            assertThat(fixture.maxX).isGreaterThanOrEqualTo(bounds.maxX - ON_THE_EDGE);
            assertThat(fixture.maxY).isGreaterThanOrEqualTo(bounds.maxY - ON_THE_EDGE);
        }
    }

    /** A step foresees that it goes on to the left; the pile's solver throws it to the right. */
    @Test
    void whatAPileThrowsBackIsFoundWhereItEndsTheStep() {
        Pool room =
                new Pool(
                        Effects.of(new Contacts(), new Restitution()),
                        Accuracy.GAME.withImpacts(ImpactMode.DISCRETE));
        room.add(BodyDefinition.fixed(Polygon.box(1, 4)).at(-0.5, 0));
        Material lively = new Material(1, 0, 1);
        BodyDefinition thrown = BodyDefinition.dynamic(new Circle(0.5)).material(lively);
        RigidBody ball = room.add(thrown.at(0.5, 0).velocity(-60, 0));
        room.step(1.0 / 60);
        assertThat(ball.x()).isCloseTo(1.5, within(1e-3));
        assertThat(room.bodyAt(ball.x() + 0.45, 0)).contains(ball);
        assertThat(room.rayCast(5, 0, 1.6, 0))
                .hasValueSatisfying(hit -> assertThat(hit.body()).isSameAs(ball));
    }

    @Test
    void bodyUnderAPointIsTheLastAddedThatHoldsIt() {
        int found = 0;
        for (int i = 0; i < COUNT; i++) {
            double x = 20 * random.nextDouble() - 10;
            double y = 10 * random.nextDouble() - 1;
            RigidBody expected = null;
            boolean isClear = true;
            for (RigidBody body : pool.bodies()) {
                double depth = depth(body, x, y);
                expected = depth >= 0 ? body : expected;
                isClear &= Math.abs(depth) > ON_THE_EDGE;
            }
            if (isClear) {
                Optional<RigidBody> answer = pool.bodyAt(x, y);
                assertThat(answer.orElse(null)).as("(%f, %f)", x, y).isSameAs(expected);
                found += expected == null ? 0 : 1;
            }
        }
        assertThat(found).isGreaterThan(COUNT / 20);
    }

    @Test
    void rayMeetsTheFirstOutlineOnItsWay() {
        int met = 0;
        for (int i = 0; i < COUNT / 4; i++) {
            double fromX = 20 * random.nextDouble() - 10;
            double fromY = 10 * random.nextDouble();
            double toX = 20 * random.nextDouble() - 10;
            double toY = 10 * random.nextDouble();
            double first = Double.POSITIVE_INFINITY;
            for (RigidBody body : pool.bodies()) {
                if (depth(body, fromX, fromY) < 0) {
                    first = Math.min(first, entry(body, fromX, fromY, toX, toY));
                }
            }
            Optional<RayHit> hit = pool.rayCast(fromX, fromY, toX, toY);
            String ray = "ray " + i + ", seed " + SEED;
            assertThat(hit.isPresent()).as(ray).isEqualTo(first <= 1);
            if (hit.isPresent()) {
                met++;
                RayHit at = hit.get();
                assertThat(at.fraction()).as(ray).isCloseTo(first, within(1e-9));
                assertThat(depth(at.body(), at.x(), at.y())).as(ray).isCloseTo(0, within(1e-9));
                assertThat(Math.hypot(at.normalX(), at.normalY())).isCloseTo(1, within(1e-12));
                double outwards = at.normalX() * (toX - fromX) + at.normalY() * (toY - fromY);
                assertThat(outwards).as(ray).isLessThanOrEqualTo(0);
            }
        }
        assertThat(met).isGreaterThan(COUNT / 16);
    }

    @Test
    void boxFindsWhatReachesIntoIt() {
        for (int i = 0; i < COUNT / 4; i++) {
            double x = 20 * random.nextDouble() - 10;
            double y = 10 * random.nextDouble() - 1;
            Aabb box = new Aabb(x, y, x + 3 * random.nextDouble(), y + 3 * random.nextDouble());
            List<RigidBody> answer = new ArrayList<>();
            pool.overlapping(box, answer::add);
            assertThat(answer).doesNotHaveDuplicates();
            for (RigidBody body : pool.bodies()) {
                String what = "box " + i + ", seed " + SEED + ", " + body;
                if (holdsSampleOf(box, body)) {
                    assertThat(answer).as(what).contains(body);
                } else if (separation(box, body) > ON_THE_EDGE) {
                    assertThat(answer).as(what).doesNotContain(body);
                }
            }
        }
    }

    /** Depth of a point below the outline, negative outside. */
    private static double depth(RigidBody body, double x, double y) {
        double dx = x - body.x();
        double dy = y - body.y();
        if (body.shape() instanceof Circle) {
            return ((Circle) body.shape()).radius() - Math.hypot(dx, dy);
        }
        double cos = Math.cos(body.angle());
        double sin = Math.sin(body.angle());
        double localX = cos * dx + sin * dy;
        double localY = cos * dy - sin * dx;
        Polygon polygon = (Polygon) body.shape();
        double depth = Double.POSITIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            double front =
                    polygon.normalX(i) * (localX - polygon.cornerX(i))
                            + polygon.normalY(i) * (localY - polygon.cornerY(i));
            depth = Math.min(depth, -front);
        }
        return depth;
    }

    /**
     * The fraction at which a ray from outside enters, infinite where it does not. Depth along a
     * ray is concave: its top is found by thirds and the entry by halves.
     */
    private static double entry(RigidBody body, double x, double y, double toX, double toY) {
        double low = 0;
        double high = 1;
        for (int i = 0; i < 200; i++) {
            double third = (high - low) / 3;
            boolean isRising =
                    depthAt(body, x, y, toX, toY, low + third)
                            < depthAt(body, x, y, toX, toY, high - third);
            low = isRising ? low + third : low;
            high = isRising ? high : high - third;
        }
        double top = (low + high) / 2;
        if (depthAt(body, x, y, toX, toY, top) < 0) {
            return Double.POSITIVE_INFINITY;
        }
        double outside = 0;
        double inside = top;
        for (int i = 0; i < 100; i++) {
            double middle = (outside + inside) / 2;
            boolean isInside = depthAt(body, x, y, toX, toY, middle) >= 0;
            outside = isInside ? outside : middle;
            inside = isInside ? middle : inside;
        }
        return inside;
    }

    private static double depthAt(
            RigidBody body, double x, double y, double toX, double toY, double fraction) {
        return depth(body, x + fraction * (toX - x), y + fraction * (toY - y));
    }

    /** Whether one of 400 points of the box lies in the body. */
    private static boolean holdsSampleOf(Aabb box, RigidBody body) {
        for (int i = 0; i < 400; i++) {
            double x = box.minX + (box.maxX - box.minX) * (i % 20) / 19;
            double y = box.minY + (box.maxY - box.minY) * (i / 20) / 19;
            if (depth(body, x, y) > ON_THE_EDGE) {
                return true;
            }
        }
        return false;
    }

    /** Largest gap along the box's two axes and the body's own: above 0 they are apart. */
    private static double separation(Aabb box, RigidBody body) {
        double middleX = (box.minX + box.maxX) / 2;
        double middleY = (box.minY + box.maxY) / 2;
        double halfX = (box.maxX - box.minX) / 2;
        double halfY = (box.maxY - box.minY) / 2;
        if (body.shape() instanceof Circle) {
            double dx = Math.max(Math.abs(body.x() - middleX) - halfX, 0);
            double dy = Math.max(Math.abs(body.y() - middleY) - halfY, 0);
            return Math.hypot(dx, dy) - ((Circle) body.shape()).radius();
        }
        Polygon polygon = (Polygon) body.shape();
        double cos = Math.cos(body.angle());
        double sin = Math.sin(body.angle());
        double minX = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        double widest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            double x = body.x() + cos * polygon.cornerX(i) - sin * polygon.cornerY(i);
            double y = body.y() + sin * polygon.cornerX(i) + cos * polygon.cornerY(i);
            minX = Math.min(minX, x);
            maxX = Math.max(maxX, x);
            minY = Math.min(minY, y);
            maxY = Math.max(maxY, y);
            double nx = cos * polygon.normalX(i) - sin * polygon.normalY(i);
            double ny = sin * polygon.normalX(i) + cos * polygon.normalY(i);
            double reach = halfX * Math.abs(nx) + halfY * Math.abs(ny);
            widest = Math.max(widest, nx * (middleX - x) + ny * (middleY - y) - reach);
        }
        double acrossX = Math.max(box.minX - maxX, minX - box.maxX);
        double acrossY = Math.max(box.minY - maxY, minY - box.maxY);
        return Math.max(widest, Math.max(acrossX, acrossY));
    }
}
