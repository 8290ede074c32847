package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** Whom a body meets, what its parts are made of, and whether it turns. */
class FilterTest {

    private static final double DT = 1 / 60.0;

    private static final Compound TWINS =
            Compound.of(Part.of(new Circle(0.2)).at(-1, 0), Part.of(new Circle(0.2)).at(1, 0));

    /** Against every two of 10³ random filters, whichever is added first. */
    @Test
    void onlyWhoIsMeantIsMet() {
        Random random = new Random(3);
        int met = 0;
        for (int i = 0; i < 500; i++) {
            Filter one = draw(random);
            Filter other = draw(random);
            Pool pool = new Pool(Effects.usual().without(Gravity.class), Accuracy.GAME);
            RigidBody a = pool.add(BodyDefinition.dynamic(new Circle(0.5)).filter(one));
            RigidBody b =
                    pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(0.9, 0).filter(other));
            pool.step(DT);
            boolean sameGroup = one.group() != 0 && one.group() == other.group();
            boolean wanted =
                    !sameGroup
                            && (one.category() & other.mask()) != 0
                            && (other.category() & one.mask()) != 0;
            assertThat(pool.touching(a, b)).as("%s, %s", one, other).isEqualTo(wanted);
            assertThat(one.meets(other)).isEqualTo(wanted);
            assertThat(a.filter()).isEqualTo(one);
            met += wanted ? 1 : 0;
        }
        assertThat(met).isBetween(100, 400);
    }

    private static Filter draw(Random random) {
        return new Filter(
                1 << random.nextInt(32) | 1 << random.nextInt(3),
                random.nextBoolean() ? ~0 : random.nextInt(),
                random.nextInt(3));
    }

    /**
     * Of 10⁵ bodies that overlap at random, exactly those whose filters meet are reported as
     * touching; all can move, for what is fixed is one floor where it overlaps. Overlap is taken
     * back at 3 m/s at most, so that who is 0.1 m away is not reached.
     */
    @Test
    void agreesWithAListOfAllPairs() {
        int met = 0;
        int passed = 0;
        for (int seed = 0; seed < 1000; seed++) {
            Random random = new Random(seed);
            Pool pool = new Pool(Effects.usual().without(Gravity.class), Accuracy.DRAFT);
            for (int i = 0; i < 100; i++) {
                pool.add(body(random));
            }
            double[][] gaps = gaps(pool);
            pool.step(DT);
            Set<Set<RigidBody>> told = new HashSet<>();
            pool.contactEvents().forEach(e -> told.add(Set.of(e.a(), e.b())));
            for (int i = 0; i < 100; i++) {
                for (int k = 0; k < i; k++) {
                    RigidBody a = pool.bodies().get(i);
                    RigidBody b = pool.bodies().get(k);
                    boolean isTold = told.contains(Set.of(a, b));
                    boolean isMeant = a.filter().meets(b.filter());
                    if (!isMeant || gaps[i][k] > 0.1) {
                        assertThat(isTold).as("seed %d: %s, %s", seed, a, b).isFalse();
                    } else if (gaps[i][k] < -1e-3) {
                        assertThat(isTold).as("seed %d: %s, %s", seed, a, b).isTrue();
                    }
                    met += isTold ? 1 : 0;
                    passed += gaps[i][k] < 0 && !isTold ? 1 : 0;
                }
            }
        }
        assertThat(met).isGreaterThan(50_000);
        assertThat(passed).isGreaterThan(50_000);
    }

    private static BodyDefinition body(Random random) {
        Shape shape =
                switch (random.nextInt(4)) {
                    case 0 -> new Circle(0.5);
                    case 1 -> Polygon.box(1.2, 0.4).rounded(0.1);
                    case 2 -> new Capsule(0.4, 0.2);
                    default -> TWINS;
                };
        return BodyDefinition.dynamic(shape)
                .at(7 * random.nextDouble(), 7 * random.nextDouble())
                .angle(7 * random.nextDouble())
                .filter(draw(random));
    }

    private static double[][] gaps(Pool pool) {
        double[][] gaps = new double[100][100];
        for (int i = 0; i < 100; i++) {
            for (int k = 0; k < i; k++) {
                RigidBody a = pool.bodies().get(i);
                RigidBody b = pool.bodies().get(k);
                double reach = a.shape().boundingRadius() + b.shape().boundingRadius();
                boolean isNear = Math.hypot(a.x() - b.x(), a.y() - b.y()) < reach + 0.2;
                gaps[i][k] =
                        isNear
                                ? Geometry.gap(a.shape(), place(a), b.shape(), place(b)).gap()
                                : Double.POSITIVE_INFINITY;
            }
        }
        return gaps;
    }

    private static Placement place(RigidBody body) {
        return new Placement(body.x(), body.y(), body.angle());
    }

    /** The body on it falls, and bodies that fall on it afterwards are caught again. */
    @Test
    void aChangeWakesWhatItMust() {
        Pool pool = new Pool();
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(10, 1)).at(0, -0.5));
        RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        Scenes.run(pool, 120);
        assertThat(box.isAwake()).isFalse();

        floor.filter(Filter.ALL.mask(0));
        assertThat(box.isAwake()).isTrue();
        assertThat(pool.touching(box, floor)).isFalse();
        pool.step(DT);
        assertThat(pool.contactEvents())
                .singleElement()
                .satisfies(e -> assertThat(e.phase()).isEqualTo(ContactEvent.Phase.END));
        Scenes.run(pool, 29);
        assertThat(box.velocityY()).isEqualTo(-9.81 * 0.5, within(1e-9));

        box.moveTo(0, 2, 0);
        floor.filter(Filter.ALL);
        Scenes.run(pool, 120);
        assertThat(box.y()).isEqualTo(0.5, within(0.01));
    }

    /** A part that meets nobody lets through what the other stops. */
    @Test
    void partsMeetByThemselves() {
        Pool pool = new Pool();
        RigidBody twins = pool.add(BodyDefinition.fixed(TWINS).filter(1, Filter.ALL.mask(0)));
        RigidBody stopped = pool.add(BodyDefinition.dynamic(Polygon.box(0.3, 0.3)).at(-1, 1));
        RigidBody falling = pool.add(BodyDefinition.dynamic(Polygon.box(0.3, 0.3)).at(1, 1));
        Scenes.run(pool, 40);
        assertThat(stopped.y()).isGreaterThan(0.3);
        assertThat(falling.y()).isLessThan(-1);
        assertThat(twins.filter(1).mask()).isZero();

        Pool restored = Pool.restore(pool.snapshot());
        assertThat(restored.bodies().get(0).filter(1)).isEqualTo(twins.filter(1));
        restored.bodies().get(0).filter(0, Filter.ALL.mask(0));
        Scenes.run(restored, 40);
        assertThat(restored.bodies().get(1).y()).isLessThan(0);
        assertThatThrownBy(() -> twins.filter(2)).hasMessageContaining("part must be 0 to 1");
    }

    /** One shoe on ice, one on rubber: braked by half the weight on the rubber. */
    @Test
    void partsHaveSurfacesOfTheirOwn() {
        Compound sledge =
                Compound.of(
                        Part.of(new Circle(0.1)).at(-1, -0.2),
                        Part.of(new Circle(0.1)).at(1, -0.2),
                        Part.of(Polygon.box(2.2, 0.2)));
        Material ice = Material.DEFAULT.friction(0);
        Material rubber = Material.DEFAULT.friction(0.9);
        Pool pool = new Pool(Effects.usual().without(Sleep.class), Accuracy.EXACT);
        pool.add(
                BodyDefinition.fixed(Polygon.box(100, 1))
                        .at(0, -0.5)
                        .material(Material.DEFAULT.friction(0.9)));
        RigidBody body =
                pool.add(
                        BodyDefinition.dynamic(sledge)
                                .at(0, 0.3 + sledge.centroidY())
                                .material(ice)
                                .material(0, rubber)
                                .velocity(3, 0));
        assertThat(body.material(0).friction()).isEqualTo(0.9);
        assertThat(body.material(1)).isEqualTo(ice);
        Scenes.run(pool, 30);
        // N₀ + N₁ = mg, and about the centre: (N₁ − N₀)·1 = μN₀·h, with h its height.
        double height = 0.3 + sledge.centroidY();
        double braked = 0.9 * 9.81 / (2 + 0.9 * height);
        assertThat(body.velocityX()).isEqualTo(3 - braked * 0.5, within(1e-4));

        body.material(0, ice);
        double speed = body.velocityX();
        Scenes.run(pool, 30);
        assertThat(body.velocityX()).isEqualTo(speed, within(1e-9));
    }

    /** Two that stand half over the edge: who may not turn stays as it is. */
    @Test
    void whoIsLockedDoesNotTurn() {
        Pool pool = new Pool(Effects.usual().without(Sleep.class), Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(1, 1)).at(0, -0.5));
        BodyDefinition slab = BodyDefinition.dynamic(Polygon.box(1, 0.1)).at(0.8, 0.05);
        RigidBody locked = pool.add(slab.lockRotation().spin(3));
        assertThat(locked.rotationLocked()).isTrue();
        Scenes.run(pool, 60);
        assertThat(locked.angle()).isZero();
        assertThat(locked.y()).isEqualTo(0.05, within(1e-3));
        locked.spin(5);
        locked.applyImpulse(0, 1e-6, 5, 5);
        assertThat(locked.angularVelocity()).isZero();
        Pool restored = Pool.restore(pool.snapshot());
        Scenes.run(restored, 60);
        assertThat(restored.bodies().get(1).angle()).isZero();

        locked.rotationLocked(false);
        Scenes.run(pool, 60);
        assertThat(locked.angle()).isLessThan(-0.1);
    }

    /** A locked body struck at its rim goes on as a point does. */
    @Test
    void aBlowOnWhoIsLockedGoesThroughItsCentre() {
        Pool pool = new Pool(Effects.usual().without(Gravity.class), Accuracy.GAME);
        Material bouncy = new Material(1, 0, 1);
        RigidBody locked =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.2, 2))
                                .material(bouncy)
                                .lockRotation());
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.1))
                                .material(bouncy)
                                .at(-1, 0.9)
                                .velocity(4, 0));
        double m = ball.mass();
        double target = locked.mass();
        Scenes.run(pool, 60);
        // Two points: v' = v·2m/(m + M).
        assertThat(locked.velocityX()).isEqualTo(4 * 2 * m / (m + target), within(1e-12));
        assertThat(locked.angularVelocity()).isZero();
    }

    /** Bits, hash and work of a scene do not tell that a filter was there and is plain. */
    @Test
    void plainFiltersSayNothing() {
        List<Long> hashes = new ArrayList<>();
        Set<Integer> bits = new HashSet<>();
        for (boolean held : new boolean[] {false, true}) {
            Pool pool = new Pool();
            RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(10, 1)).at(0, -0.5));
            RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 3));
            if (held) {
                box.filter(Filter.ALL.category(2));
                box.filter(Filter.ALL);
            }
            Scenes.run(pool, 90);
            hashes.add(Double.doubleToLongBits(box.y()));
            bits.add(pool.bitsPerBody());
        }
        assertThat(hashes.get(0)).isEqualTo(hashes.get(1));
        assertThat(bits).hasSize(2);
    }
}
