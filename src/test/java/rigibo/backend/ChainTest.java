package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;

import java.util.SplittableRandom;
import java.util.stream.Stream;

/** Bodies on, in and under chains. */
@Execution(ExecutionMode.CONCURRENT)
class ChainTest {

    private static final double DT = 1 / 60.0;

    private static final Effects AWAKE = Effects.usual().without(Sleep.class);

    private static final Material SMOOTH = new Material(1, 0, 0);

    static Stream<Shape> shapes() {
        return Stream.of(
                Polygon.box(1, 0.5),
                new Circle(0.3),
                new Capsule(0.4, 0.2),
                Polygon.box(0.8, 0.4).rounded(0.05),
                Polygon.regular(6, 0.4));
    }

    /** From right to left, so that the air is up; its corners are not numbers that end in zeros. */
    static Chain floor(double fromX, double toX, int edges) {
        double[] xy = new double[2 * edges + 2];
        for (int i = 0; i <= edges; i++) {
            xy[2 * i] = toX + (fromX - toX) * i / edges;
        }
        return Chain.open(xy);
    }

    /** Nothing pushes along the way: 1e-9 is round-off of 200 steps, a bump would be 1e-3. */
    @ParameterizedTest
    @MethodSource("shapes")
    void whatSlidesOverAFlatChainKeepsItsSpeed(Shape shape) {
        for (Preset preset : Preset.values()) {
            Pool pool = new Pool(AWAKE, preset.accuracy);
            pool.add(BodyDefinition.fixed(floor(-5, 118.3, 1000)).material(SMOOTH));
            RigidBody body = pool.add(resting(shape).velocity(30, 0).material(SMOOTH));
            for (int i = 0; i < 200; i++) {
                pool.step(DT);
                assertThat(body.velocityX())
                        .as("%s, step %d", preset, i)
                        .isEqualTo(30, within(1e-9));
            }
            assertThat(body.y()).isEqualTo(height(shape), within(1e-3 * shape.smallestWidth()));
        }
    }

    private static BodyDefinition resting(Shape shape) {
        return BodyDefinition.dynamic(shape).at(0, height(shape));
    }

    /** Of the centre of mass over the lowest point. */
    private static double height(Shape shape) {
        var box = new rigibo.backend.geometry.Aabb();
        shape.bounds(0, 0, 1, 0, box);
        return -box.minY;
    }

    /** Without a load there is no friction, and nothing to bump into either. */
    @ParameterizedTest
    @MethodSource("shapes")
    void whatSkimsOverAFlatChainWithoutWeightIsNotTouched(Shape shape) {
        Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
        pool.add(BodyDefinition.fixed(floor(-5, 118.3, 1000)));
        RigidBody body = pool.add(resting(shape).velocity(30, 0));
        for (int i = 0; i < 200; i++) {
            pool.step(DT);
            assertThat(body.velocityX()).isEqualTo(30);
            assertThat(body.velocityY()).isEqualTo(0);
        }
    }

    /** From the air nothing passes, whatever its speed; v²/2g is far more than it may rise. */
    @ParameterizedTest
    @MethodSource("shapes")
    void nothingPassesFromTheAir(Shape shape) {
        SplittableRandom random = new SplittableRandom(5);
        for (double speed : new double[] {0.5, 5, 50, 500}) {
            Pool pool = new Pool(AWAKE, Accuracy.GAME);
            pool.add(BodyDefinition.fixed(hills(random, 1)));
            for (int i = 0; i < 8; i++) {
                double angle = random.nextDouble(-Math.PI, 0);
                RigidBody body =
                        pool.add(
                                BodyDefinition.dynamic(shape)
                                        .at(12 * i - 42, 6)
                                        .angle(random.nextDouble(6))
                                        .velocity(
                                                0.2 * speed * Math.cos(angle),
                                                speed * Math.sin(angle))
                                        .group(1));
                for (int step = 0; step < 120; step++) {
                    pool.step(DT);
                    boolean isOverLand = Math.abs(body.x()) < 60;
                    assertThat(!isOverLand || body.y() > -0.9)
                            .as(
                                    "%s at %s m/s, body %d, step %d: (%s, %s)",
                                    shape, speed, i, step, body.x(), body.y())
                            .isTrue();
                }
                pool.remove(body);
            }
        }
    }

    /** Corners between heights of 0 and the one given, m, half a metre apart; 140 m wide. */
    private static Chain hills(SplittableRandom random, double height) {
        int edges = 280;
        double[] xy = new double[2 * edges + 2];
        for (int i = 0; i <= edges; i++) {
            xy[2 * i] = 70 - 0.5 * i;
            xy[2 * i + 1] = height * random.nextDouble();
        }
        return Chain.open(xy);
    }

    /** Its flight is the parabola that it would fly alone, to the bit. */
    @ParameterizedTest
    @MethodSource("shapes")
    void whatComesOutOfTheMatterPassesUntouched(Shape shape) {
        for (double speed : new double[] {0.5, 3, 17, 120, 1000}) {
            Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
            Pool empty = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
            pool.add(BodyDefinition.fixed(hills(new SplittableRandom(3), 0.2)));
            BodyDefinition rising =
                    BodyDefinition.dynamic(shape).at(0.1, -2).velocity(0.3, speed).spin(speed / 4);
            RigidBody body = pool.add(rising);
            RigidBody alone = empty.add(rising);
            for (int i = 0; i < 5 / speed * 60 + 2; i++) {
                pool.step(DT);
                empty.step(DT);
                assertThat(body.y()).isEqualTo(alone.y());
                assertThat(body.velocityX()).isEqualTo(alone.velocityX());
                assertThat(body.velocityY()).isEqualTo(speed);
                assertThat(body.angularVelocity()).isEqualTo(speed / 4);
            }
            assertThat(body.y()).isGreaterThan(1.5);
            body.velocity(0, -5);
            for (int i = 0; i < 120; i++) {
                pool.step(DT);
            }
            assertThat(body.y()).as("falls back on it").isGreaterThan(0);
        }
    }

    /** Straight down there is nothing else to meet: what is stopped stays where it is. */
    @ParameterizedTest
    @MethodSource("shapes")
    void nothingFallsThroughAFlatChain(Shape shape) {
        for (double speed : new double[] {1e3, 1e5, 1e7}) {
            Pool pool = new Pool(AWAKE, Accuracy.GAME);
            pool.add(BodyDefinition.fixed(floor(-5, 6.1, 37)));
            BodyDefinition falling = BodyDefinition.dynamic(shape).at(0, 3).velocity(0, -speed);
            RigidBody body = pool.add(falling);
            for (int i = 0; i < 60; i++) {
                pool.step(DT);
            }
            assertThat(body.y()).isEqualTo(height(shape), within(0.01));
        }
    }

    /**
     * A disc slides in a bowl of 720 edges. At every corner it loses the part of its velocity that
     * goes into the next edge, v·sin δ with δ = 2π/720, and so 2(v²/2)sin²δ at most in all; nothing
     * else is lost, and nothing gained but a thousandth, which is what FINE allows a step's curve.
     * Its centre stays on a circle of R − r but for the height of an arc over its chord, R(1 −
     * cos(δ/2)) = 0.2 mm, and what a contact may overlap, a thousandth of the width.
     */
    @Test
    void aDiscFollowsABowl() {
        double bowl = 20;
        double r = 0.5;
        int corners = 720;
        double delta = 2 * Math.PI / corners;
        Pool pool = new Pool(AWAKE, Accuracy.FINE);
        pool.add(BodyDefinition.fixed(circle(bowl, corners, true)).material(SMOOTH));
        double start = bowl - r;
        double tilt = 0.8;
        RigidBody disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(r))
                                .at(start * Math.sin(tilt), -start * Math.cos(tilt))
                                .material(SMOOTH));
        double top = disc.y();
        double fall = top + start;
        double mayLose = 0;
        for (int i = 0; i < 900; i++) {
            pool.step(DT);
            double away = Math.hypot(disc.x(), disc.y());
            assertThat(away).as("step %d", i).isEqualTo(start, within(1.2e-3));
            double v = Math.hypot(disc.velocityX(), disc.velocityY());
            double crossed = v * DT / (bowl * delta);
            mayLose += crossed * v * v * Math.sin(delta) * Math.sin(delta);
            double energy = v * v / 2 + 9.81 * (disc.y() - top);
            double allowed = 1e-3 * 9.81 * fall;
            assertThat(energy).as("step %d", i).isBetween(-mayLose - allowed, allowed);
        }
        assertThat(mayLose).as("that there is anything to know").isLessThan(0.1 * 9.81 * fall);
    }

    /** A ring of so many corners, of air within or without. */
    static Chain circle(double radius, int corners, boolean isAirWithin) {
        double[] xy = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            xy[2 * i] = radius * Math.cos(angle);
            xy[2 * i + 1] = radius * Math.sin(angle);
        }
        Chain rock = Chain.loop(xy);
        return isAirWithin ? rock.reversed() : rock;
    }

    /**
     * Over the crest of a wheel at v²&lt;gR it stays on, and rides with the slope of the circle.
     */
    @ParameterizedTest
    @MethodSource("shapes")
    void nothingBumpsIntoTheCornersOfAnArch(Shape shape) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        double radius = 100;
        pool.add(BodyDefinition.fixed(circle(radius, 1200, false)).material(SMOOTH));
        double y = radius + height(shape);
        RigidBody body =
                pool.add(BodyDefinition.dynamic(shape).at(-1, y).velocity(30, 0).material(SMOOTH));
        // 30 m/s is just under √(g·R) = 31.3 m/s: it hardly weighs anything, and any bump throws
        // it.
        for (int i = 0; i < 40; i++) {
            pool.step(DT);
            double v = Math.hypot(body.velocityX(), body.velocityY());
            double fallen = y - body.y();
            assertThat(v)
                    .as("step %d", i)
                    .isEqualTo(Math.sqrt(900 + 2 * 9.81 * fallen), within(0.02));
        }
    }

    /**
     * A belt of edges that run to the left carries a crate at its speed, one that stands stops it.
     */
    @Test
    void anEdgeMayBeAConveyor() {
        Pool pool = new Pool(AWAKE.with(new SurfaceSpeed()), Accuracy.GAME);
        Chain floor = Chain.open(10, 0, 0, 0, -10, 0);
        Material rough = new Material(1, 0.8, 0);
        RigidBody ground =
                pool.add(
                        BodyDefinition.fixed(floor)
                                .material(rough)
                                .material(0, rough.surfaceSpeed(2)));
        RigidBody crate = pool.add(resting(Polygon.box(1, 0.5)).material(rough));
        crate.moveTo(5, 0.25, 0);
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        assertThat(crate.velocityX()).as("carried").isEqualTo(-2, within(1e-6));
        for (int i = 0; i < 240; i++) {
            pool.step(DT);
        }
        assertThat(crate.velocityX()).as("on the part that stands").isEqualTo(0, within(1e-6));
        assertThat(crate.x()).isLessThan(0.5);
        assertThat(ground.material(0).surfaceSpeed()).isEqualTo(2);
        assertThat(ground.material(1).surfaceSpeed()).isEqualTo(0);
    }

    @Test
    void anEdgeIsAPartWithAFilterAndANumber() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody ground =
                pool.add(
                        BodyDefinition.fixed(Chain.open(10, 0, 0, 0, -10, 0))
                                .filter(1, Filter.ALL.mask(0)));
        RigidBody falls = pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(-5, 0.5));
        RigidBody stays = pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(5, 0.5));
        for (int i = 0; i < 30; i++) {
            pool.step(DT);
        }
        assertThat(falls.y()).isLessThan(-0.5);
        assertThat(stays.y()).isEqualTo(0.5, within(1e-3));
        assertThat(pool.contactEvents()).hasSize(1);
        ContactEvent contact = pool.contactEvents().get(0);
        assertThat(contact.a()).isSameAs(ground);
        assertThat(contact.partA()).isEqualTo(0);
    }

    /** A drum of 120 edges turns with what is in it; nothing gets out. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 3, -8})
    void aDrumThatTurnsKeepsWhatIsInIt(double spin) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.kinematic(circle(4, 120, true)).spin(spin));
        for (int i = 0; i < 30; i++) {
            Shape shape = i % 2 == 0 ? Polygon.box(0.5, 0.3) : new Capsule(0.2, 0.15);
            pool.add(BodyDefinition.dynamic(shape).at(i % 6 * 0.7 - 1.8, i / 6 * 0.6 - 1.5));
        }
        for (int i = 0; i < 600; i++) {
            pool.step(DT);
        }
        for (RigidBody body : pool.bodies()) {
            assertThat(Math.hypot(body.x(), body.y())).as("%s", body).isLessThan(4);
        }
    }

    /**
     * The corner at the end of a ledge pushes the disc round it, and no energy is lost or gained.
     */
    @Test
    void aDiscRollsRoundTheEndOfALedge() {
        Pool pool = new Pool(AWAKE, Accuracy.FINE);
        pool.add(BodyDefinition.fixed(Chain.open(0, 0, -5, 0)).material(SMOOTH));
        RigidBody disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(1))
                                .at(-0.5, 1)
                                .velocity(0.2, 0)
                                .material(SMOOTH));
        boolean turned = false;
        for (int i = 0; i < 300 && disc.y() > -3; i++) {
            pool.step(DT);
            double v2 = disc.velocityX() * disc.velocityX() + disc.velocityY() * disc.velocityY();
            assertThat(v2 / 2 + 9.81 * (disc.y() - 1)).isEqualTo(0.02, within(0.02));
            double fromCorner = Math.hypot(disc.x(), disc.y());
            assertThat(disc.x() < 0 || fromCorner > 0.995).as("step %d", i).isTrue();
            turned |= disc.x() > 0.3 && disc.x() < 0.6 && fromCorner < 1.005;
        }
        assertThat(turned).as("went round the corner, not straight down").isTrue();
        // It leaves where cos φ = 2/3 + v₀²/3g: x = sin φ ≈ 0.745.
    }

    @Test
    void queriesMeetTheSideOfTheAir() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody ground = pool.add(BodyDefinition.fixed(Chain.open(5, 0, 0, 0, -5, 1)));
        RayHit hit = pool.rayCast(2, 3, 2, -3).orElseThrow();
        assertThat(hit.body()).isSameAs(ground);
        assertThat(hit.part()).isEqualTo(0);
        assertThat(hit.y()).isEqualTo(0, within(1e-15));
        assertThat(hit.normalY()).isEqualTo(1);
        assertThat(pool.rayCast(2, -3, 2, 3)).isEmpty();
        assertThat(pool.bodyAt(2, 0)).isEmpty();
        NearestPoint nearest = pool.nearest(2, 0.5, 1, Filter.ALL).orElseThrow();
        assertThat(nearest.distance()).isEqualTo(0.5, within(1e-15));
        assertThat(
                        pool.cast(
                                        new Circle(0.25),
                                        rigibo.backend.geometry.Placement.at(2, 2),
                                        0,
                                        -4,
                                        Filter.ALL)
                                .orElseThrow()
                                .fraction())
                .isEqualTo(1.75 / 4, within(1e-9));
    }

    @Test
    void aSnapshotWithinAPassageGoesOnToTheBit() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(hills(new SplittableRandom(3), 0.2)));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0.1, -2).velocity(0, 8));
        pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(3, 2));
        for (int i = 0; i < 16; i++) {
            pool.step(DT);
        }
        Pool copy = Pool.restore(pool.snapshot());
        assertThat(copy.stateHash()).isEqualTo(pool.stateHash());
        for (int i = 0; i < 200; i++) {
            pool.step(DT);
            copy.step(DT);
            assertThat(copy.stateHash()).as("step %d", i).isEqualTo(pool.stateHash());
        }
        assertThat(pool.bodies().get(1).y()).isGreaterThan(0);
    }

    @Test
    void isRefusedForWhatMoves() {
        Chain chain = Chain.open(1, 0, 0, 0);
        assertThatThrownBy(() -> BodyDefinition.dynamic(chain))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Chain");
        Pool pool = new Pool();
        RigidBody ground = pool.add(BodyDefinition.fixed(chain));
        RigidBody disc = pool.add(BodyDefinition.dynamic(new Circle(1)).at(0, 5));
        assertThatThrownBy(() -> ground.type(BodyType.DYNAMIC)).hasMessageContaining("Chain");
        assertThatThrownBy(() -> disc.shape(chain)).hasMessageContaining("Chain");
        disc.type(BodyType.STATIC);
        disc.shape(chain);
        assertThat(disc.shape()).isEqualTo(chain);
        disc.shape(new Circle(1));
        disc.type(BodyType.DYNAMIC);
        pool.step(DT);
    }
}
