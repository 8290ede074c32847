package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Pieces;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;

import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;

/**
 * Casts, overlaps and nearest points against the list of all bodies, one by one: of 10⁵ bodies of
 * every kind and filter, the pools with contacts and those without together.
 */
@Execution(ExecutionMode.CONCURRENT)
class ShapeQueriesTest {

    private static final int POOLS = 34;
    private static final int BODIES = 1500;
    private static final int QUESTIONS_OF_A_POOL = 5;
    private static final int QUESTIONS = POOLS * QUESTIONS_OF_A_POOL;
    private static final double SIDE = 40;

    private final Random random = new Random(5);

    private Pool pool(boolean hasContacts) {
        Effects effects = hasContacts ? Effects.of(new Contacts(), new Sensors()) : Effects.of();
        Pool pool = new Pool(effects, Accuracy.GAME);
        for (int i = 0; i < BODIES; i++) {
            BodyDefinition body =
                    ofAnyType()
                            .at(coordinate(), coordinate())
                            .angle(2 * Math.PI * random.nextDouble())
                            .filter(anyFilter());
            pool.add(hasContacts && i % 50 == 0 ? body.mass(1).sensor() : body);
        }
        return pool;
    }

    private BodyDefinition ofAnyType() {
        return switch (random.nextInt(4)) {
            case 0 -> BodyDefinition.dynamic(shape());
            case 1 -> BodyDefinition.kinematic(shape());
            case 2 -> BodyDefinition.fixed(chain());
            default -> BodyDefinition.fixed(shape());
        };
    }

    private Chain chain() {
        double edge = 0.1 + 0.4 * random.nextDouble();
        return Chain.open(edge, 0, 0, edge * random.nextDouble(), -edge, 0);
    }

    private Filter anyFilter() {
        int mask = random.nextInt(4) == 0 ? random.nextInt() : ~0;
        return new Filter(1 << random.nextInt(3), mask, random.nextInt(4));
    }

    private static boolean isMeant(RigidBody body, Filter filter) {
        return !body.isSensor() && filter.meets(body.filter());
    }

    private double coordinate() {
        return SIDE * (random.nextDouble() - 0.5);
    }

    private Shape shape() {
        double size = 0.1 + 0.4 * random.nextDouble();
        return switch (random.nextInt(5)) {
            case 0 -> new Circle(size);
            case 1 -> new Capsule(size, 0.3 * size);
            case 2 -> Polygon.box(size, 2 * size);
            case 3 -> Pieces.cup(size);
            default -> Polygon.box(size, size).rounded(0.2 * size);
        };
    }

    private Placement place() {
        return new Placement(coordinate(), coordinate(), 7 * random.nextDouble());
    }

    private Filter filter() {
        return new Filter(1 << random.nextInt(2), 1 + random.nextInt(7), random.nextInt(3));
    }

    private static Placement placeOf(RigidBody body) {
        return new Placement(body.x(), body.y(), body.angle());
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aCastMeetsTheFirstOfAll(boolean hasContacts) {
        Pool pool = null;
        int hits = 0;
        for (int i = 0; i < QUESTIONS; i++) {
            pool = i % QUESTIONS_OF_A_POOL == 0 ? pool(hasContacts) : pool;
            Shape shape = shape();
            Placement from = place();
            double dx = coordinate();
            double dy = coordinate();
            Filter filter = filter();
            double first = Double.POSITIVE_INFINITY;
            for (RigidBody body : pool.bodies()) {
                if (isMeant(body, filter)) {
                    OptionalDouble at =
                            Geometry.cast(shape, from, dx, dy, body.shape(), placeOf(body));
                    first = Math.min(first, at.orElse(Double.POSITIVE_INFINITY));
                }
            }
            RayHit hit = pool.cast(shape, from, dx, dy, filter).orElse(null);
            assertThat(hit == null ? Double.POSITIVE_INFINITY : hit.fraction()).isEqualTo(first);
            if (hit != null) {
                hits++;
                requireTouching(shape, from, dx, dy, hit);
            }
        }
        assertThat(hits).isGreaterThan(QUESTIONS / 2);
    }

    /** A billionth of the narrower shape is left, unless the two overlapped at the start. */
    private static void requireTouching(
            Shape shape, Placement from, double dx, double dy, RayHit hit) {
        Placement there =
                new Placement(
                        from.x() + hit.fraction() * dx,
                        from.y() + hit.fraction() * dy,
                        from.angle());
        ShapeGap gap = Geometry.gap(shape, there, hit.body().shape(), placeOf(hit.body()));
        assertThat(gap.gap()).isLessThan(1e-9);
        if (hit.fraction() > 0) {
            assertThat(gap.gap()).isGreaterThan(-1e-9);
            assertThat(Math.hypot(gap.otherX() - hit.x(), gap.otherY() - hit.y())).isLessThan(1e-6);
            assertThat(hit.normalX() * dx + hit.normalY() * dy).as("faces the way").isNegative();
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aRayMeetsAllInTheirOrder(boolean hasContacts) {
        Pool pool = null;
        int met = 0;
        for (int i = 0; i < QUESTIONS; i++) {
            pool = i % QUESTIONS_OF_A_POOL == 0 ? pool(hasContacts) : pool;
            double fromX = coordinate();
            double fromY = coordinate();
            double toX = coordinate();
            double toY = coordinate();
            Filter filter = filter();
            List<RayHit> hits = pool.rayCastAll(fromX, fromY, toX, toY, filter);
            Set<RigidBody> wanted = new HashSet<>();
            for (RigidBody body : pool.bodies()) {
                boolean starts = Geometry.holds(body.shape(), placeOf(body), fromX, fromY);
                if (isMeant(body, filter) && !starts && crosses(body, fromX, fromY, toX, toY)) {
                    wanted.add(body);
                }
            }
            assertThat(hits.stream().map(RayHit::body)).containsExactlyInAnyOrderElementsOf(wanted);
            double before = 0;
            for (RayHit hit : hits) {
                assertThat(hit.fraction()).isBetween(before, 1.0);
                before = hit.fraction();
            }
            assertThat(pool.rayCast(fromX, fromY, toX, toY, filter))
                    .isEqualTo(hits.stream().findFirst());
            met += hits.size();
        }
        assertThat(met).isGreaterThan(3 * QUESTIONS);
    }

    /** A disc so thin that what it does not meet a ray does not meet, but by a billionth. */
    private static boolean crosses(
            RigidBody body, double fromX, double fromY, double toX, double toY) {
        Shape thin = new Circle(1e-9);
        return Geometry.cast(
                        thin,
                        Placement.at(fromX, fromY),
                        toX - fromX,
                        toY - fromY,
                        body.shape(),
                        placeOf(body))
                .isPresent();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whatAShapeReachesIntoIsFound(boolean hasContacts) {
        Pool pool = null;
        int found = 0;
        for (int i = 0; i < QUESTIONS; i++) {
            pool = i % QUESTIONS_OF_A_POOL == 0 ? pool(hasContacts) : pool;
            Shape shape = i % 2 == 0 ? shape() : Pieces.cup(3);
            Placement at = place();
            Filter filter = filter();
            Set<RigidBody> inside = new HashSet<>();
            pool.overlapping(shape, at, filter, inside::add);
            for (RigidBody body : pool.bodies()) {
                double gap = Geometry.gap(shape, at, body.shape(), placeOf(body)).gap();
                assertThat(inside.contains(body)).isEqualTo(isMeant(body, filter) && gap <= 0);
            }
            found += inside.size();
        }
        assertThat(found).isGreaterThan(QUESTIONS);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void theNearestPointIsOfNobodyFarther(boolean hasContacts) {
        Pool pool = null;
        Shape point = new Circle(1e-9);
        int found = 0;
        for (int i = 0; i < QUESTIONS; i++) {
            pool = i % QUESTIONS_OF_A_POOL == 0 ? pool(hasContacts) : pool;
            double x = coordinate();
            double y = coordinate();
            Filter filter = filter();
            double least = Double.POSITIVE_INFINITY;
            for (RigidBody body : pool.bodies()) {
                if (isMeant(body, filter)) {
                    ShapeGap gap =
                            Geometry.gap(point, Placement.at(x, y), body.shape(), placeOf(body));
                    least = Math.min(least, Math.max(0, gap.gap() + 1e-9));
                }
            }
            NearestPoint nearest = pool.nearest(x, y, 0.5, filter).orElse(null);
            if (nearest == null) {
                assertThat(least).isGreaterThan(0.5 - 1e-12);
            } else {
                found++;
                assertThat(nearest.distance()).isEqualTo(least, within(1e-8));
                assertThat(Math.hypot(nearest.x() - x, nearest.y() - y))
                        .isEqualTo(nearest.distance(), within(1e-12));
            }
        }
        assertThat(found).isGreaterThan(QUESTIONS / 4);
    }

    /** Closed forms: of a disc on a floor, of corners, and of the part that is nearer. */
    @Test
    void geometryTellsGapContactAndImpact() {
        Shape floor = Polygon.box(10, 1);
        Shape disc = new Circle(0.5);
        ShapeGap gap = Geometry.gap(floor, Placement.ORIGIN, disc, Placement.at(2, 3));
        assertThat(gap.gap()).isEqualTo(2, within(1e-15));
        assertThat(gap.normalY()).isEqualTo(1, within(1e-15));
        assertThat(gap.y()).isEqualTo(0.5, within(1e-15));
        assertThat(gap.otherY()).isEqualTo(2.5, within(1e-15));
        assertThat(Geometry.contacts(floor, Placement.ORIGIN, disc, Placement.at(2, 3), 1.9))
                .isEmpty();
        assertThat(
                        Geometry.contacts(
                                floor,
                                Placement.ORIGIN,
                                Polygon.box(2, 2),
                                Placement.at(0, 1.4),
                                0))
                .singleElement()
                .satisfies(
                        contact -> {
                            assertThat(contact.points()).hasSize(2);
                            assertThat(contact.points().get(0).gap())
                                    .isEqualTo(-0.1, within(1e-15));
                        });
        Movement still = new Movement(Placement.ORIGIN, 0, 0, 0);
        Movement falling = new Movement(Placement.at(2, 3), 1, -4, 9);
        assertThat(Geometry.timeOfImpact(floor, still, disc, falling, 1).orElseThrow())
                .isEqualTo(0.5, within(1e-9));
        assertThat(Geometry.timeOfImpact(floor, still, disc, falling, 0.4)).isEmpty();
        Shape bell =
                Compound.of(Part.of(new Circle(0.2)).at(-1, 0), Part.of(new Circle(0.2)).at(1, 0));
        Placement turned = new Placement(0, 3, 0.5);
        ShapeGap ofPart = Geometry.gap(bell, turned, floor, Placement.ORIGIN);
        assertThat(ofPart.part()).isZero();
        assertThat(ofPart.gap()).isEqualTo(2.5 - Math.sin(0.5) - 0.2, within(1e-14));
        assertThat(Geometry.holds(bell, turned, Math.cos(0.5), 3 + Math.sin(0.5))).isTrue();
        assertThat(Geometry.holds(bell, turned, 0, 3)).isFalse();
        assertThatThrownBy(() -> Geometry.gap(null, turned, floor, turned))
                .hasMessageContaining("Geometry.gap shape");
        assertThatThrownBy(() -> Placement.at(Double.NaN, 0)).hasMessageContaining("Placement.x");
    }

    /**
     * A rod turns beside the end of an open chain, whose matter it may pass on its way: what is
     * told is where the two touch, and not where they are near in a direction that does not push.
     */
    @Test
    void whatTurnsBesideAnOpenEndIsMetWhereTheyTouch() {
        Chain ground = Chain.open(3, 0, 0, 0);
        Movement still = new Movement(Placement.ORIGIN, 0, 0, 0);
        SplittableRandom random = new SplittableRandom(7);
        int met = 0;
        for (int i = 0; i < 2000; i++) {
            Shape rod = new Capsule(random.nextDouble(0.3, 1), random.nextDouble(0.02, 0.1));
            Placement from =
                    new Placement(
                            random.nextDouble(-1.5, 0.5),
                            random.nextDouble(-1, 1.5),
                            random.nextDouble(0, 3));
            Movement turning =
                    new Movement(
                            from,
                            random.nextDouble(-0.5, 0.5),
                            random.nextDouble(-0.5, 0.5),
                            random.nextDouble(-6, 6));
            OptionalDouble time = Geometry.timeOfImpact(ground, still, rod, turning, 1);
            boolean isApart = Geometry.gap(ground, Placement.ORIGIN, rod, from).gap() > 0;
            if (isApart && time.isPresent()) {
                double t = time.getAsDouble();
                Placement at =
                        new Placement(
                                from.x() + t * turning.velocityX(),
                                from.y() + t * turning.velocityY(),
                                from.angle() + t * turning.angularVelocity());
                assertThat(Geometry.contacts(ground, Placement.ORIGIN, rod, at, 1e-5))
                        .as("%s %s", rod, turning)
                        .isNotEmpty();
                met++;
            }
        }
        assertThat(met).isGreaterThan(75);
    }
}
