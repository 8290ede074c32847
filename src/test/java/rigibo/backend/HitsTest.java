package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Which impacts a step tells, where, when and how fast. */
class HitsTest {

    private static final double DT = 1 / 60.0;
    private static final double G = 9.81;
    private static final Effects AWAKE = Effects.usual().without(Sleep.class);
    private static final Effects WEIGHTLESS = AWAKE.without(Gravity.class);

    private static Material elastic(double elasticity) {
        return Material.DEFAULT.elasticity(elasticity);
    }

    private static RigidBody floor(Pool pool) {
        return pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
    }

    /** A hit and when it was, s of the pool's time. */
    private record Told(HitEvent hit, double time) {}

    private static List<Told> run(Pool pool, int steps) {
        List<Told> told = new ArrayList<>();
        for (int i = 0; i < steps; i++) {
            double start = pool.time();
            pool.step(DT);
            for (HitEvent hit : pool.hits()) {
                assertThat(hit.time()).isBetween(0.0, DT);
                told.add(new Told(hit, start + hit.time()));
            }
        }
        return told;
    }

    private void tellsAFall(Accuracy accuracy, double elasticity, double tolerance) {
        Pool pool = new Pool(AWAKE, accuracy);
        RigidBody floor = floor(pool);
        double height = 2;
        double radius = 0.25;
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(radius))
                                .at(0.3, height + radius)
                                .material(elastic(elasticity)));
        Told first = run(pool, 60).get(0);
        double speed = Math.sqrt(2 * G * height);
        assertThat(first.hit.speed()).isCloseTo(speed, within(tolerance));
        assertThat(first.time).isCloseTo(Math.sqrt(2 * height / G), within(tolerance));
        assertThat(first.hit.x()).isCloseTo(0.3, within(1e-12));
        assertThat(first.hit.y()).isCloseTo(0, within(tolerance));
        boolean isFloorA = first.hit.a() == floor;
        assertThat(isFloorA ? first.hit.b() : first.hit.a()).isSameAs(ball);
        assertThat(first.hit.normalY()).isEqualTo(isFloorA ? 1 : -1);
    }

    /** The tolerance of impacts is 1e-9 m for a body of 1 m; this one is half as wide. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void tellsAFallsSpeedAndTimeExactly(double elasticity) {
        tellsAFall(Accuracy.EXACT, elasticity, 1e-9);
    }

    /** An error of at most 1e-4 m in place means a smaller one in m/s and in s, at 6 m/s. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void tellsAFallWithinThePresetsTolerance(double elasticity) {
        tellsAFall(Accuracy.GAME, elasticity, Accuracy.GAME.impactTolerance());
    }

    /** After the first, bounces follow each other by 2ev/g, each e times as fast as the last. */
    @Test
    void tellsEveryBounceOnce() {
        Pool pool = new Pool(AWAKE, Accuracy.EXACT);
        floor(pool);
        double e = 0.8;
        pool.add(BodyDefinition.dynamic(new Circle(0.25)).at(0, 1.25).material(elastic(e)));
        List<Told> told = run(pool, 150);
        double speed = Math.sqrt(2 * G);
        double time = Math.sqrt(2 / G);
        assertThat(told).hasSizeGreaterThan(3);
        for (Told one : told) {
            assertThat(one.hit.speed()).isCloseTo(speed, within(1e-8));
            assertThat(one.time).isCloseTo(time, within(1e-8));
            speed *= e;
            time += 2 * speed / G;
        }
    }

    /** Two discs of 0.5 m, 3 m apart, meet after 2 m at 3 + 1 m/s, 1.5 m on for the faster one. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1})
    void tellsTwoDiscsThatMeetHeadOn(double elasticity) {
        Pool pool = new Pool(WEIGHTLESS, Accuracy.EXACT);
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.5)).material(elastic(elasticity));
        RigidBody left = pool.add(disc.at(0, 0).velocity(3, 0));
        RigidBody right = pool.add(disc.at(3, 0).velocity(-1, 0));
        List<Told> told = run(pool, 60);
        assertThat(told).hasSize(1);
        HitEvent hit = told.get(0).hit;
        assertThat(told.get(0).time).isCloseTo(0.5, within(1e-9));
        assertThat(hit.speed()).isCloseTo(4, within(1e-12));
        assertThat(hit.x()).isCloseTo(2, within(1e-8));
        assertThat(hit.y()).isEqualTo(0);
        assertThat(List.of(hit.a(), hit.b())).containsExactly(left, right);
        assertThat(hit.normalX()).isEqualTo(1);
    }

    @Test
    void namesThePartThatWasStruck() {
        Pool pool = new Pool(WEIGHTLESS, Accuracy.GAME);
        Compound dumbbell =
                Compound.of(Part.of(new Circle(0.5)).at(-2, 0), Part.of(new Circle(0.5)).at(2, 0));
        RigidBody struck = pool.add(BodyDefinition.dynamic(dumbbell));
        RigidBody bullet =
                pool.add(BodyDefinition.dynamic(new Circle(0.1)).at(2, 2).velocity(0, -5));
        List<Told> told = run(pool, 30);
        assertThat(told).isNotEmpty();
        HitEvent hit = told.get(0).hit;
        boolean isStruckA = hit.a() == struck;
        assertThat(isStruckA ? hit.b() : hit.a()).isSameAs(bullet);
        assertThat(isStruckA ? hit.partA() : hit.partB()).isEqualTo(1);
        assertThat(isStruckA ? hit.partB() : hit.partA()).isEqualTo(0);
        assertThat(hit.speed()).isCloseTo(5, within(1e-9));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void tellsNothingOfWhatRests(double elasticity) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        floor(pool);
        BodyDefinition box =
                BodyDefinition.dynamic(Polygon.box(1, 1)).material(elastic(elasticity));
        for (int i = 0; i < 3; i++) {
            pool.add(box.at(0, i + 0.5));
        }
        run(pool, 1);
        assertThat(run(pool, 120)).isEmpty();
    }

    /** The stack rests before the ball comes, which falls 1 m onto it. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5})
    void tellsWhatFallsOntoAPileOnce(double elasticity) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        floor(pool);
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1));
        pool.add(box.at(0, 0.5));
        RigidBody top = pool.add(box.at(0, 1.5));
        RigidBody ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.1))
                                .at(0, 3.1)
                                .material(elastic(elasticity)));
        List<Told> ofBall =
                run(pool, 30).stream()
                        .filter(told -> told.hit.a() == ball || told.hit.b() == ball)
                        .toList();
        assertThat(ofBall).hasSize(1);
        Told told = ofBall.get(0);
        assertThat(List.of(told.hit.a(), told.hit.b())).contains(top);
        assertThat(told.time).isCloseTo(Math.sqrt(2 / G), within(1e-4));
        assertThat(told.hit.speed()).isCloseTo(Math.sqrt(2 * G), within(1e-3));
        assertThat(told.hit.y()).isCloseTo(2, within(1e-3));
    }

    /**
     * In a row of discs that touch at rest nothing is in flight but the first; the impact goes on
     * to the last within the instant.
     */
    @Test
    void tellsAnImpactThatGoesThroughARow() {
        Pool pool = new Pool(WEIGHTLESS, Accuracy.GAME);
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.5)).material(elastic(1));
        RigidBody first = pool.add(disc.at(-2, 0).velocity(2, 0));
        for (int i = 0; i < 4; i++) {
            pool.add(disc.at(i, 0));
        }
        List<Told> told = run(pool, 45);
        assertThat(told).isNotEmpty();
        assertThat(told.get(0).time).isCloseTo(0.5, within(1e-4));
        assertThat(told.get(0).hit.speed()).isCloseTo(2, within(1e-9));
        assertThat(List.of(told.get(0).hit.a(), told.get(0).hit.b())).contains(first);
    }

    @Test
    void showsByVisitorWhatTheListTells() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        floor(pool);
        pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 0.201).velocity(0, -1));
        pool.step(DT);
        List<HitEvent> shown = new ArrayList<>();
        pool.forEachHit(hit -> shown.add(hit.event()));
        assertThat(shown).isNotEmpty().isEqualTo(pool.hits());
        assertThatThrownBy(() -> pool.forEachHit(hit -> pool.step(DT)))
                .isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> pool.forEachHit(null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("visitor");
    }

    @Test
    void tellsNothingOfABodyThatIsGone() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        floor(pool);
        BodyDefinition ball = BodyDefinition.dynamic(new Circle(0.2)).at(0, 0.201).velocity(0, -1);
        RigidBody gone = pool.add(ball);
        RigidBody stays = pool.add(ball.at(3, 0.201));
        pool.step(DT);
        assertThat(pool.hits()).hasSize(2);
        pool.remove(gone);
        pool.add(ball.at(-3, 5)); // takes the slot
        assertThat(pool.hits()).hasSize(1);
        HitEvent left = pool.hits().get(0);
        assertThat(List.of(left.a(), left.b())).contains(stays);
        pool.effects(Effects.of(new Gravity(0, -G)));
        pool.step(DT);
        assertThat(pool.hits()).isEmpty();
    }

    @Test
    void changesNothingWhetherAskedOrNot() {
        Pool asked = Scenes.values()[0].build();
        Pool left = Scenes.values()[0].build();
        for (int i = 0; i < 120; i++) {
            asked.step(DT);
            left.step(DT);
            asked.hits();
            assertThat(asked.stateHash()).isEqualTo(left.stateHash());
        }
        assertThat(asked.snapshot()).isEqualTo(left.snapshot());
    }

    /** Visits, so many that their code is compiled: compiling may make constants. */
    private static final int VISITS = 20_000;

    private double fastest;
    private int seen;
    private final Consumer<HitView> watching =
            hit -> {
                fastest = Math.max(fastest, hit.speed);
                seen++;
            };

    @Test
    void showsByVisitorWithoutGarbage() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        floor(pool);
        pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 0.201).velocity(0, -1));
        pool.step(DT);
        int hits = pool.hits().size();
        long bytes =
                Allocation.ofThirdRun(
                        () -> {
                            for (int i = 0; i < VISITS; i++) {
                                pool.forEachHit(watching);
                            }
                        });
        assertThat(bytes).isZero();
        assertThat(seen).isEqualTo(3 * VISITS * hits).isPositive();
        assertThat(fastest).isCloseTo(Math.sqrt(1 + 2 * G * 0.001), within(1e-3));
    }
}
