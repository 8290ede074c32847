package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** Drag against air, at rest and moving. */
class AirTest {

    private static final double GRAVITY = 9.81;

    /** v = w(1 − e^(−kt)), exactly: a steady wind is a constant acceleration k·w. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void linearDragTakesUpASteadyWind(Preset level) {
        Pool pool = new Pool(Effects.of(new Drag(), new Wind(6, -2)), level.accuracy);
        RigidBody leaf = leaf(pool, 3);
        for (int i = 1; i <= 180; i++) {
            pool.step(Scenes.DT);
            double share = 1 - Math.exp(-3 * i * Scenes.DT);
            assertThat(leaf.velocityX()).isEqualTo(6 * share, within(1e-12));
            assertThat(leaf.velocityY()).isEqualTo(-2 * share, within(1e-12));
        }
    }

    /** v′ = k(w·sin Ωt − v) from rest: v = kw(k·sin Ωt − Ω·cos Ωt + Ω·e^(−kt))/(k² + Ω²). */
    @ParameterizedTest
    @EnumSource(Level.class)
    void linearDragFollowsGusts(Level level) {
        double k = 3;
        double omega = 4;
        Wind gusty = new Wind(6, 0, time -> StrictMath.sin(omega * time));
        Pool pool = new Pool(Effects.of(new Drag(), gusty), level.accuracy);
        RigidBody leaf = leaf(pool, k);
        for (int i = 1; i <= 180; i++) {
            pool.step(Scenes.DT);
            double t = i * Scenes.DT;
            double wave = k * Math.sin(omega * t) - omega * Math.cos(omega * t);
            double truth = 6 * k * (wave + omega * Math.exp(-k * t)) / (k * k + omega * omega);
            assertThat(leaf.velocityX()).isEqualTo(truth, within(level.limit(1e-11, 1e-8)));
        }
    }

    private static RigidBody leaf(Pool pool, double drag) {
        return pool.add(
                BodyDefinition.dynamic(new Circle(0.1)).material(Material.DEFAULT.drag(drag)));
    }

    /** The air's speed u = w − v over the body decays as u₀/(1 + u₀κt), κ = ½ρcA/m. */
    @ParameterizedTest
    @EnumSource(Level.class)
    void quadraticDragTakesUpTheWind(Level level) {
        Pool pool = new Pool(Effects.of(new AirDrag(1.2, 1.1), new Wind(20, 0)), level.accuracy);
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.5)).mass(2));
        double kappa = 1.2 * 1.1 / 2 / 2;
        for (int i = 1; i <= 180; i++) {
            pool.step(Scenes.DT);
            double truth = 20 - 20 / (1 + 20 * kappa * i * Scenes.DT);
            assertThat(ball.velocityX()).isEqualTo(truth, within(level.limit(1e-9, 1e-6)));
        }
    }

    /** In wind a falling body's terminal velocity is the wind's, less v_t along gravity. */
    @ParameterizedTest
    @EnumSource(Level.class)
    void terminalVelocityIsAgainstTheAir(Level level) {
        double terminal = 20;
        double mass = 2 * 1.2 * terminal * terminal / 2 / GRAVITY;
        Pool pool =
                new Pool(
                        Effects.of(new Gravity(0, -GRAVITY), new AirDrag(1.2, 2), new Wind(7, 3)),
                        level.accuracy);
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(0.5)).mass(mass));
        Scenes.run(pool, 60 * 60);
        assertThat(ball.velocityX()).isEqualTo(7, within(1e-9));
        assertThat(ball.velocityY()).isEqualTo(3 - terminal, within(1e-9));
    }

    /** A feather of 20 mg thrown at 200 m/s: its drag alone would stop it within a microsecond. */
    @Test
    void noDragIsTooStrong() {
        Pool pool =
                new Pool(
                        Effects.of(new Gravity(0, -GRAVITY), new AirDrag(1.2, 1.1)),
                        Accuracy.DRAFT);
        RigidBody feather =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.1, 0.02))
                                .mass(2e-5)
                                .velocity(200, 50));
        double terminal = Math.sqrt(2 * 2e-5 * GRAVITY / (1.2 * 1.1 * 0.1));
        for (int i = 0; i < 600; i++) {
            assertThat(pool.step(Scenes.DT).quarantined()).isZero();
            assertThat(Math.abs(feather.velocityX())).isLessThan(200);
            assertThat(Math.abs(feather.velocityY())).isLessThan(50);
        }
        assertThat(feather.velocityX()).isEqualTo(0, within(1e-3));
        assertThat(feather.velocityY()).isEqualTo(-terminal, within(0.01 * terminal));
    }
}
