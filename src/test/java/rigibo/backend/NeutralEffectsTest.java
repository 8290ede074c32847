package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

import java.util.stream.Stream;

/** An effect that does nothing leaves every bit as if it were not declared. */
@Execution(ExecutionMode.CONCURRENT)
class NeutralEffectsTest {

    private static final int STEPS = 600;
    private static final Material MATERIAL = new Material(1, 0.5, 0.3).drag(0.4);

    static Stream<Arguments> neutralEffects() {
        Effects usual = Scenes.usualWithoutSleep();
        Effects damped = usual.with(new Drag());
        return Stream.of(
                        Accuracy.DRAFT, Accuracy.GAME, Accuracy.GAME.withIntegrator(Integrator.RK4))
                .flatMap(
                        accuracy ->
                                Stream.of(
                                        neutral(accuracy, usual, MATERIAL.drag(0), new Drag()),
                                        neutral(accuracy, usual, MATERIAL, new RollingResistance()),
                                        neutral(accuracy, usual, MATERIAL, new SurfaceSpeed()),
                                        neutral(accuracy, usual, MATERIAL, new Joints()),
                                        neutral(accuracy, usual, MATERIAL, new Sensors()),
                                        neutral(accuracy, usual, MATERIAL, new Thrust()),
                                        neutral(accuracy, usual, MATERIAL, new AirDrag(0, 1)),
                                        neutral(accuracy, usual, MATERIAL, new AirDrag(1, 0)),
                                        neutral(accuracy, damped, MATERIAL, new Wind(0, 0)),
                                        neutral(
                                                accuracy,
                                                damped,
                                                MATERIAL,
                                                new Wind(3, 0, time -> 0)),
                                        neutral(
                                                accuracy,
                                                usual,
                                                MATERIAL,
                                                new CentralForce(1, 2, 0, -2)),
                                        neutral(
                                                accuracy,
                                                usual,
                                                MATERIAL,
                                                new Fan(new Fan.Jet(0, -9, 1.5, 99, 99, 0))),
                                        neutral(
                                                accuracy,
                                                usual,
                                                MATERIAL,
                                                new Magnet(new Magnet.Pole(1, 2, 0, 99))),
                                        neutral(
                                                accuracy,
                                                usual,
                                                MATERIAL,
                                                new Buoyancy(-1e3, 1000, 5)),
                                        neutral(
                                                accuracy,
                                                damped,
                                                MATERIAL,
                                                new Field(at -> at.push(0, 0))),
                                        neutral(
                                                accuracy,
                                                usual.without(Friction.class),
                                                MATERIAL.friction(0),
                                                new Friction()),
                                        neutral(
                                                accuracy,
                                                usual.without(Restitution.class),
                                                MATERIAL.elasticity(0),
                                                new Restitution())));
    }

    private static Arguments neutral(
            Accuracy accuracy, Effects without, Material material, Effect added) {
        String words = added.title() + " at " + accuracy.substeps() + " " + accuracy.integrator();
        return Arguments.of(words, accuracy, without, material, added);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("neutralEffects")
    void neutralEqualsUndeclaredToTheBit(
            String words, Accuracy accuracy, Effects without, Material material, Effect added) {
        Pool plain = tumble(without, accuracy, material);
        Pool neutral = tumble(without.with(added), accuracy, material);
        for (int step = 1; step <= STEPS; step++) {
            plain.step(Scenes.DT);
            neutral.step(Scenes.DT);
            assertThat(neutral.stateHash())
                    .as("%s, step %d", words, step)
                    .isEqualTo(plain.stateHash());
        }
    }

    private static Pool tumble(Effects effects, Accuracy accuracy, Material material) {
        Pool pool = new Pool(effects, accuracy);
        Scenes.addTray(pool);
        Scenes.addMixture(pool, 18);
        for (RigidBody body : pool.bodies()) {
            body.material(material);
        }
        return pool;
    }

    @Test
    void undeclaredColumnsAreNotThere() {
        Pool pool = new Pool(Effects.of(new Gravity(0, -9.81)), Accuracy.GAME);
        Bodies columns = pool.columns();
        assertThat(columns.forceX).isNull();
        assertThat(columns.forceY).isNull();
        assertThat(columns.torque).isNull();
        assertThat(columns.rollingResistance).isNull();
        assertThat(columns.surfaceSpeed).isNull();
        assertThat(columns.drag).isNull();
        assertThat(columns.pullX).isNull();
        assertThat(columns.pullY).isNull();
        assertThat(columns.pullTurn).isNull();
        assertThat(columns.fixtureMinX).isNull();
        assertThat(columns.firstPair).isNull();
        assertThat(columns.pileTime).isNull();
        assertThat(columns.stillTime).isNull();
        assertThat(columns.friction).isNull();
        assertThat(columns.elasticity).isNull();
        assertThat(pool.plan()).doesNotContain("wind", "integrate", "thrust", "manifold", "island");
    }

    @Test
    void columnsComeAndGoWithTheirEffects() {
        Pool pool = new Pool();
        pool.effects(pool.effects().with(new SurfaceSpeed()).with(new AirDrag(1.2, 1)));
        assertThat(pool.columns().surfaceSpeed).isNotNull();
        assertThat(pool.columns().pullX).isNotNull();
        assertThat(pool.plan()).contains("surface speed", "changing forces", "integrate");
        pool.effects(pool.effects().without(SurfaceSpeed.class).without(AirDrag.class));
        assertThat(pool.columns().surfaceSpeed).isNull();
        assertThat(pool.columns().pullX).isNull();
    }

    /** A double is 64 bits, a number of a leaf or a pair 32, a flag 8. */
    static Stream<Arguments> bitsOfEffects() {
        Effects straight = Effects.of(new Contacts(), new Gravity(0, -9.81));
        Effects contacts = straight.with(new Rotation());
        return Stream.of(
                Arguments.of(Effects.of(), new Contacts(), 6 * 64 + 2 * 32 + 2 * 8),
                Arguments.of(Effects.of(), new Rotation(), 5 * 64),
                Arguments.of(straight, new Rotation(), (5 + 1) * 64),
                Arguments.of(straight.with(new Sleep()), new Rotation(), (5 + 2) * 64),
                Arguments.of(straight.with(new Thrust()), new Rotation(), (5 + 2) * 64),
                Arguments.of(straight.with(new AirDrag(1, 1)), new Rotation(), (5 + 2) * 64),
                Arguments.of(straight, new Sleep(), 3 * 64),
                Arguments.of(straight, new Thrust(), 2 * 64),
                Arguments.of(straight, new AirDrag(1, 1), 2 * 64),
                Arguments.of(contacts, new Friction(), 64),
                Arguments.of(contacts, new Restitution(), 64),
                Arguments.of(contacts, new Sleep(), 4 * 64),
                Arguments.of(contacts, new RollingResistance(), 64),
                Arguments.of(contacts, new ContinuousImpacts(), 0),
                Arguments.of(contacts, new Joints(), 0),
                Arguments.of(contacts, new Sensors(), 0),
                Arguments.of(contacts.with(new Friction()), new SurfaceSpeed(), 64),
                Arguments.of(contacts, new Thrust(), 3 * 64),
                Arguments.of(contacts, new Drag(), 64),
                Arguments.of(contacts, new AirDrag(1, 1), 3 * 64),
                Arguments.of(contacts.with(new AirDrag(1, 1)), new CentralForce(0, 0, 1, 1), 0));
    }

    @ParameterizedTest
    @MethodSource("bitsOfEffects")
    void memoryOfABodyIsWhatTheColumnsAddUpTo(Effects without, Effect added, int bits) {
        int before = new Pool(without, Accuracy.GAME).bitsPerBody();
        int after = new Pool(without.with(added), Accuracy.GAME).bitsPerBody();
        assertThat(after - before).isEqualTo(bits);
    }

    /** Every array of the bodies is counted: its type says how many bits an element has. */
    @Test
    void noColumnIsForgotten() throws IllegalAccessException {
        Bodies columns = new Pool().columns();
        int bits = 0;
        for (java.lang.reflect.Field field : Bodies.class.getFields()) {
            Object column = field.get(columns);
            if (field.getType().isArray() && column != null) {
                bits += bitsOf(field.getType().getComponentType());
            }
        }
        assertThat(new Pool().bitsPerBody()).isEqualTo(bits);
    }

    private static int bitsOf(Class<?> element) {
        return element == double.class ? 64 : element == boolean.class ? 8 : 32;
    }

    @Test
    void bodiesAreFoundWhereTheyFlyWithoutContacts() {
        Pool pool = new Pool(Effects.of(new Gravity(0, -9.81)), Accuracy.GAME);
        RigidBody ball = pool.add(Scenes.restingBox());
        double height = ball.y();
        for (int i = 0; i < 60; i++) {
            pool.step(Scenes.DT);
        }
        assertThat(pool.bodyAt(0, height)).isEmpty();
        assertThat(pool.bodyAt(ball.x(), ball.y())).contains(ball);
    }

    @Test
    void contactsComeAndGoWithoutATrace() {
        Pool pool = new Pool();
        Scenes.addFloor(pool);
        RigidBody box = pool.add(Scenes.restingBox());
        Effects usual = pool.effects();
        pool.step(Scenes.DT);
        pool.effects(Effects.of(new Gravity(0, -9.81)));
        pool.step(Scenes.DT);
        assertThat(box.velocityY()).isCloseTo(-9.81 * Scenes.DT, offset(1e-6));
        pool.step(Scenes.DT);
        assertThat(pool.contactEvents()).as("once the end was told").isEmpty();
        pool.effects(usual);
        for (int i = 0; i < 60; i++) {
            pool.step(Scenes.DT);
        }
        assertThat(box.y()).isCloseTo(0.5, offset(1e-3));
    }

    @Test
    void flightAloneCountsNothing() {
        Pool pool = new Pool(Effects.of(new Gravity(0, -9.81)), Accuracy.GAME);
        Scenes.addMixture(pool, 18);
        for (int i = 0; i < 60; i++) {
            StepReport report = pool.step(Scenes.DT);
            assertThat(report.pairs()).isZero();
            assertThat(report.contacts()).isZero();
            assertThat(report.impacts()).isZero();
            assertThat(report.evaluations()).isZero();
            assertThat(report.rows()).isZero();
        }
    }

    @Test
    void contactsWithoutFrictionHaveNoFrictionRows() {
        Effects plain = Effects.of(new Gravity(0, -9.81), new Contacts());
        assertThat(rowsOfABoxOnAFloor(plain)).isEqualTo(1);
        assertThat(rowsOfABoxOnAFloor(plain.with(new Friction()))).isEqualTo(2);
    }

    /** In the first step: later ones find that it rests and write no rows. */
    private static int rowsOfABoxOnAFloor(Effects effects) {
        Pool pool = new Pool(effects, Accuracy.GAME);
        Scenes.addFloor(pool);
        pool.add(Scenes.restingBox());
        return pool.step(Scenes.DT).rows();
    }
}
