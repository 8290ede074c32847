package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** Bodies of many parts in a pool. */
class CompoundBodyTest {

    private static final double DT = 1 / 60.0;

    private static final Effects AWAKE = Effects.usual().without(Sleep.class);

    private static final Compound DUMBBELL =
            Compound.of(
                    Part.of(Polygon.box(1, 0.1)),
                    Part.of(new Circle(0.2)).at(-0.5, 0),
                    Part.of(new Circle(0.2)).at(0.5, 0));

    /** Open above: 1 m wide, 0.6 m high, walls of 0.1 m. */
    private static final Compound CUP =
            Compound.of(
                    Part.of(Polygon.box(1, 0.1)),
                    Part.of(Polygon.box(0.1, 0.5)).at(-0.45, 0.3),
                    Part.of(Polygon.box(0.1, 0.5)).at(0.45, 0.3));

    /** Its centre flies the parabola v·t − g·t²/2, and it turns at one rate. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void aThrownDumbbellFliesAsAPoint(Preset preset) {
        Pool pool = new Pool(AWAKE, preset.accuracy);
        RigidBody body = pool.add(BodyDefinition.dynamic(DUMBBELL).velocity(3, 8).spin(20));
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        double t = pool.time();

        assertThat(body.x()).isEqualTo(3 * t, within(1e-12));
        assertThat(body.y()).isEqualTo(8 * t - 9.81 * t * t / 2, within(1e-12));
        assertThat(body.angle()).isEqualTo(20 * t, within(1e-12));
        assertThat(body.inertia()).isEqualTo(DUMBBELL.massProperties(1).inertia(), within(1e-15));
    }

    /** Its tips run 0.5 m in a step, and the post is 4 mm wide. */
    @ParameterizedTest
    @CsvSource({"60, 0.55", "60, -0.6", "-45, 0.62", "300, 0.65", "1000, 0.69"})
    void aSpinningDumbbellIsNeverSteppedOver(double spin, double post) {
        Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
        RigidBody bar = pool.add(BodyDefinition.dynamic(DUMBBELL).spin(spin));
        RigidBody thin = pool.add(BodyDefinition.fixed(Polygon.box(0.004, 0.004)).at(0, post));
        double quarter = 0.3 * Math.PI / Math.abs(spin);
        int begun = 0;
        for (int i = 0; i < Math.ceil(2 * quarter / DT) + 1; i++) {
            pool.step(DT);
            begun +=
                    (int)
                            pool.contactEvents().stream()
                                    .filter(e -> e.a() == bar && e.b() == thin)
                                    .filter(e -> e.phase() == ContactEvent.Phase.BEGIN)
                                    .count();
        }
        assertThat(begun).as("met the post").isPositive();
        assertThat(bar.kineticEnergy())
                .isLessThan(DUMBBELL.massProperties(1).inertia() * spin * spin / 2);
    }

    /** The ball's weight is carried by the cup, and the cup's and the ball's by the floor. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void aCupCarriesABall(Preset preset) {
        Pool pool = new Pool(AWAKE, preset.accuracy);
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        RigidBody cup = pool.add(BodyDefinition.dynamic(CUP).at(0, 0.05 + CUP.centroidY()));
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0.1, 0.301));
        for (int i = 0; i < 240; i++) {
            pool.step(DT);
        }
        double carried = 0;
        double stood = 0;
        for (ContactEvent event : pool.contactEvents()) {
            boolean isOfBall = event.a() == ball || event.b() == ball;
            carried += isOfBall ? event.impulse() : 0;
            stood += event.a() == floor ? event.impulse() : 0;
            if (isOfBall) {
                assertThat(event.partA()).as("the cup's bottom").isZero();
            }
        }

        assertThat(carried).isEqualTo(ball.mass() * 9.81 * DT, within(1e-6));
        assertThat(stood).isEqualTo((ball.mass() + cup.mass()) * 9.81 * DT, within(1e-6));
        assertThat(ball.y()).isEqualTo(0.3, within(2e-3));
        assertThat(pool.kineticEnergy()).isLessThan(1e-8);
    }

    /** A quick cup takes its ball along: the wall pushes it, and it does not leave. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 5, 20})
    void aDrivenCupTakesItsBallAlong(double speed) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        RigidBody cup = pool.add(BodyDefinition.kinematic(CUP).velocity(speed, 0));
        RigidBody ball =
                pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 0.25 - CUP.centroidY()));
        for (int i = 0; i < 120; i++) {
            pool.step(DT);
        }
        assertThat(ball.x() - cup.x()).isBetween(-0.21, 0.21);
        assertThat(ball.velocityX()).isEqualTo(speed, within(0.2 * speed));
    }

    /** It stands while its centre of mass is over its foot, and tips where it is not. */
    @ParameterizedTest
    @CsvSource({"0.7, false", "0.98, false", "1.02, true", "1.4, true"})
    void anLTipsAtItsCorner(double share, boolean tips) {
        // A foot of 0.4 m × 0.4 m, and an arm so long that the centre is at share × 0.2 m.
        double arm = armFor(0.2 * share);
        Compound ell =
                Compound.of(
                        Part.of(Polygon.box(0.4, 0.4)),
                        Part.of(Polygon.box(arm, 0.2)).at(arm / 2 - 0.2, 0.3));
        assertThat(ell.centroidX()).isEqualTo(0.2 * share, within(1e-9));
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        RigidBody body =
                pool.add(BodyDefinition.dynamic(ell).at(ell.centroidX(), 0.2 + ell.centroidY()));
        for (int i = 0; i < 180; i++) {
            pool.step(DT);
        }
        assertThat(body.angle() < -0.01).isEqualTo(tips);
        if (!tips) {
            assertThat(body.angle()).isEqualTo(0, within(1e-9));
        }
    }

    /** Of the arm's length that puts the centre there: bisection of a growing function. */
    private static double armFor(double centre) {
        double low = 0.4;
        double high = 10;
        for (int i = 0; i < 60; i++) {
            double arm = (low + high) / 2;
            double foot = 0.16;
            double bar = 0.2 * arm;
            boolean isFarther = bar * (arm / 2 - 0.2) / (foot + bar) > centre;
            low = isFarther ? low : arm;
            high = isFarther ? arm : high;
        }
        return low;
    }

    /** A weeble's centre is below its middle: it swings back up from any side. */
    @Test
    void aTumblerRightsItself() {
        Compound weeble = Compound.of(Part.of(new Circle(0.5))).centredAt(0, -0.2);
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(100, 1)).at(0, -0.5));
        Material rolling = Material.DEFAULT.friction(1);
        double tilt = 0.1;
        RigidBody body =
                pool.add(
                        BodyDefinition.dynamic(weeble)
                                .material(rolling)
                                .angle(tilt)
                                .at(0.2 * Math.sin(tilt), 0.5 - 0.2 * Math.cos(tilt)));
        // It rolls: T = 2π·√((I + m·(r−d)²)/(m·g·d)), a small swing.
        double inertia = body.inertia() / body.mass() + 0.09;
        double period = 2 * Math.PI * Math.sqrt(inertia / (9.81 * 0.2));
        int steps = (int) Math.round(period / 2 / DT);
        double lowest = tilt;
        for (int i = 0; i < steps; i++) {
            pool.step(DT);
            lowest = Math.min(lowest, body.angle());
        }
        // Half a period later it leans as far to the other side; tilt²/16 of it is the sine's.
        assertThat(body.angle()).isEqualTo(-tilt, within(0.02 * tilt));
        assertThat(lowest).isGreaterThan(-1.01 * tilt);
    }

    /**
     * ω² = m·g·d/(I + m·(r − d)²) of a rolling disc whose centre of mass lies d below its middle;
     * the swing of 0.01 rad adds 1e-5 to the period at most.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void aTumblersPeriodIsThatOfThePendulumThatRolls(Preset preset) {
        double r = 0.5;
        double d = 0.2;
        double tilt = 0.01;
        Pool pool = new Pool(AWAKE, preset.accuracy);
        Material rolling = Material.DEFAULT.friction(1);
        pool.add(BodyDefinition.fixed(Polygon.box(100, 1)).at(0, -0.5).material(rolling));
        Compound weeble = Compound.of(Part.of(new Circle(r))).centredAt(0, -d);
        RigidBody body =
                pool.add(
                        BodyDefinition.dynamic(weeble)
                                .material(rolling)
                                .angle(tilt)
                                .at(d * Math.sin(tilt), r - d * Math.cos(tilt)));
        double steiner = body.inertia() + body.mass() * (r - d) * (r - d);
        double period = 2 * Math.PI * Math.sqrt(steiner / (body.mass() * 9.81 * d));
        double first = nextUpright(pool, body);
        double last = first;
        for (int i = 0; i < 10; i++) {
            last = nextUpright(pool, body);
        }
        // A leapfrog's period is short by (ω·h)²/24; where its middle is asked once a step only,
        // the step counts for h: (0.1)²/24 = 4e-4 of it.
        assertThat(last - first).isEqualTo(5 * period, within(1e-3 * 5 * period));
    }

    /** When the body next stands upright, on the line between two steps. */
    private static double nextUpright(Pool pool, RigidBody body) {
        double before;
        do {
            before = body.angle();
            pool.step(DT);
        } while (before * body.angle() > 0 || before == 0);
        return pool.time() - DT * body.angle() / (body.angle() - before);
    }

    @Test
    void questionsNameThePart() {
        Pool pool = new Pool(AWAKE.without(Gravity.class), Accuracy.GAME);
        RigidBody cup = pool.add(BodyDefinition.dynamic(CUP).at(0, CUP.centroidY()));
        pool.step(DT);

        RayHit hit = pool.rayCast(-3, 0.4, 3, 0.4).orElseThrow();
        assertThat(hit.body()).isSameAs(cup);
        assertThat(hit.part()).isEqualTo(1);
        assertThat(hit.x()).isEqualTo(-0.5, within(1e-12));
        assertThat(pool.rayCast(0, 3, 0, -3).orElseThrow().part()).isZero();
        assertThat(pool.rayCast(0, 0.4, 3, 0.4).orElseThrow().part()).isEqualTo(2);
        assertThat(pool.rayCast(0.45, 0.4, -3, 0.4)).as("begins in the wall").isEmpty();
        assertThat(pool.bodyAt(0.45, 0.4)).contains(cup);
        assertThat(pool.bodyAt(0, 0.4)).as("the hollow").isEmpty();
        List<RigidBody> inside = new ArrayList<>();
        pool.overlapping(new Aabb(-3, -3, 3, 3), inside::add);
        assertThat(inside).containsExactly(cup);
        inside.clear();
        pool.overlapping(new Aabb(-0.3, 0.1, 0.3, 0.5), inside::add);
        assertThat(inside).as("the hollow").isEmpty();
        Aabb fixture = new Aabb();
        cup.sizeFixture(fixture);
        assertThat(fixture.minX).isLessThanOrEqualTo(-0.5);
        assertThat(fixture.maxY).isGreaterThanOrEqualTo(0.55);
    }

    /** A compound that is exchanged, removed, retyped or restored leaves no part behind. */
    @Test
    void aReportCountsBodiesAndNotTheirParts() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.fixed(Chain.open(3, 0, 2, 0, 1, 0, 0, 0)).at(0, -5));
        pool.add(
                BodyDefinition.dynamic(
                        Compound.of(Part.of(new Circle(0.2)), Part.of(new Circle(0.2)).at(1, 0))));
        assertThat(pool.step(1 / 60.0).bodies()).isEqualTo(2);
        assertThat(pool.report().awake()).isEqualTo(1);
    }

    @Test
    void partsComeAndGoWithTheirBody() {
        Pool pool = new Pool(Effects.usual(), Accuracy.GAME);
        RigidBody floor = pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        RigidBody first = pool.add(BodyDefinition.dynamic(CUP).at(0, 1));
        RigidBody second = pool.add(BodyDefinition.dynamic(Polygon.box(0.3, 0.3)).at(0, 2));
        Scenes.run(pool, 60);
        assertThat(pool.touching(first, floor)).isTrue();

        first.shape(Polygon.box(1, 0.2));
        second.moveTo(0, 2, 0);
        second.shape(DUMBBELL);
        Scenes.run(pool, 60);
        second.type(BodyType.STATIC);
        second.moveTo(0, 3, 0);
        first.shape(CUP);
        Scenes.run(pool, 60);
        second.type(BodyType.DYNAMIC);
        floor.moveTo(0, -1, 0);
        Scenes.run(pool, 200);
        assertThat(first.isAwake()).isFalse();
        assertThat(pool.bodies()).containsExactly(floor, first, second);
        Pool restored = Pool.restore(pool.snapshot());
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());

        pool.remove(floor);
        restored.remove(restored.bodies().get(0));
        Scenes.run(pool, 30);
        Scenes.run(restored, 30);
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
        assertThat(first.velocityY()).as("falls").isLessThan(-4);
        pool.remove(first);
        pool.remove(second);
        assertThat(pool.bodies()).isEmpty();
        assertThat(pool.step(DT).bodies()).isZero();
    }

    /**
     * Two cups of 20 m whose walls are 4 m apart stand on a floor, and a marble strikes a wall of
     * one. The wall that it shakes may get 0.4 m in the step (twice the marble's way), so that no
     * part of one cup is near a part of the other: what pairs are of is 3 parts by the floor each,
     * and the marble by what it may meet.
     */
    @Test
    void aPartThatIsStruckLooksRoundItselfAlone() {
        Compound cup =
                Compound.of(
                        Part.of(Polygon.box(20, 0.5)),
                        Part.of(Polygon.box(0.5, 10)).at(-9.75, 5.25),
                        Part.of(Polygon.box(0.5, 10)).at(9.75, 5.25));
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(80, 1)).at(0, -0.5));
        RigidBody left = pool.add(BodyDefinition.dynamic(cup));
        left.moveTo(-12, left.y() - left.originY() + 0.25, 0);
        RigidBody right = pool.add(BodyDefinition.dynamic(cup));
        right.moveTo(12, left.y(), 0);
        Scenes.run(pool, 5);
        RigidBody marble =
                pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 9).velocity(-12, 0));
        int most = 0;
        for (int i = 0; i < 20; i++) {
            most = Math.max(most, pool.step(DT).pairs());
        }
        assertThat(marble.velocityX()).as("has struck").isGreaterThan(-12);
        assertThat(most).isLessThanOrEqualTo(9);
    }

    /** A scene without compounds does not pay for one that another pool has. */
    @Test
    void columnsComeWithTheFirstCompound() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.dynamic(new Circle(1)));
        int before = pool.bitsPerBody();
        pool.add(BodyDefinition.dynamic(CUP).at(5, 5));

        assertThat(pool.bitsPerBody() - before).as("owner, next shape, part").isEqualTo(96);
    }
}
