package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Integrator;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** An effect that does nothing leaves every bit as if it were not declared. */
class NeutralEffectsTest {

    private static final int STEPS = 240;
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
            assertThat(bits(neutral)).as("%s, step %d", words, step).isEqualTo(bits(plain));
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

    private static List<Long> bits(Pool pool) {
        List<Long> bits = new ArrayList<>();
        for (RigidBody body : pool.bodies()) {
            bits.add(Double.doubleToRawLongBits(body.x()));
            bits.add(Double.doubleToRawLongBits(body.y()));
            bits.add(Double.doubleToRawLongBits(body.angle()));
            bits.add(Double.doubleToRawLongBits(body.velocityX()));
            bits.add(Double.doubleToRawLongBits(body.velocityY()));
            bits.add(Double.doubleToRawLongBits(body.angularVelocity()));
        }
        return bits;
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
        Pool pool = new Pool(Effects.of(new Gravity(0, -9.81), new Contacts()), Accuracy.GAME);
        Scenes.addFloor(pool);
        pool.add(Scenes.restingBox());
        assertThat(pool.step(Scenes.DT).rows()).isEqualTo(1);
        pool.effects(pool.effects().with(new Friction()));
        assertThat(pool.step(Scenes.DT).rows()).isEqualTo(2);
    }
}
