package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** Water of density 1 up to the level 0. */
class BuoyancyTest {

    private static final double GRAVITY = 9.81;

    private static Pool pool(Level level, double drag) {
        return new Pool(
                Effects.of(new Gravity(0, -GRAVITY), new Rotation(), new Buoyancy(0, 1, drag)),
                level.accuracy);
    }

    private static BodyDefinition afloat(Shape shape, double density) {
        return BodyDefinition.dynamic(shape).material(new Material(density, 0, 0));
    }

    /**
     * A body that weighs nothing in the water loses speed and spin as e^(−dt), whatever its shape.
     */
    @ParameterizedTest
    @EnumSource(Level.class)
    void waterBrakesEveryPart(Level level) {
        Pool pool = pool(level, 2);
        for (Shape shape : new Shape[] {Polygon.box(1, 2), new Circle(1), Polygon.regular(5, 1)}) {
            RigidBody body = pool.add(afloat(shape, 1).at(0, -50).velocity(3, 1).spin(5));
            Scenes.run(pool, 60);
            double left = Math.exp(-2);
            double limit = level.limit(1e-11, 1e-8);
            assertThat(body.velocityX()).isEqualTo(3 * left, within(limit));
            assertThat(body.velocityY()).isEqualTo(1 * left, within(limit));
            assertThat(body.angularVelocity()).isEqualTo(5 * left, within(limit));
            pool.remove(body);
        }
    }

    /** A wide box rights itself and comes to rest ρh deep; a disc of ρ = ½ to its middle. */
    @ParameterizedTest
    @EnumSource(Level.class)
    void floatersComeToRestAtTheirDepth(Level level) {
        Pool pool = pool(level, 3);
        RigidBody box = pool.add(afloat(Polygon.box(3, 1), 0.3).at(0, 1).angle(0.3));
        RigidBody disc = pool.add(afloat(new Circle(1), 0.5).at(20, 1));
        Scenes.run(pool, 3600);
        assertThat(box.y()).isEqualTo(0.2, within(1e-8));
        assertThat(box.angle()).isEqualTo(0, within(1e-8));
        assertThat(disc.y()).isEqualTo(0, within(1e-8));
    }

    /**
     * A box of density ρ that bobs upright: y = y₀ + a·cos(√(g/ρ)·t). It lists by round-off alone,
     * which is no force to shorten substeps for: the fourth-order method errs by 5e-9 m in a
     * second, one of the first order by 1e-6 m and more.
     */
    @Test
    void roundOffOfItsTorqueDoesNotDisturbWhatBobs() {
        Shape halves =
                Compound.of(
                        Part.of(Polygon.box(1.5, 1)).at(-0.75, 0),
                        Part.of(Polygon.box(1.5, 1)).at(0.75, 0));
        for (double list : new double[] {0, 1e-17, 1e-15, 1e-13, 1e-11}) {
            for (Shape shape : new Shape[] {Polygon.box(3, 1), halves}) {
                Pool pool = pool(Level.GAME, 0);
                RigidBody box = pool.add(afloat(shape, 0.5).at(0, 0.2).angle(list));
                for (int i = 0; i < 300; i++) {
                    pool.step(1.0 / 60);
                    double y = 0.2 * Math.cos(Math.sqrt(GRAVITY / 0.5) * pool.time());
                    assertThat(box.y()).as("%s, step %d", shape, i).isEqualTo(y, within(1e-7));
                }
            }
        }
    }

    /** A raft of 1.2 kg and 4 m with 0.2 kg on it goes 1.4/4 m deep, as a pile. */
    @ParameterizedTest
    @EnumSource(Level.class)
    void loadedRaftFloatsDeeper(Level level) {
        Pool pool =
                new Pool(Scenes.usualWithoutSleep().with(new Buoyancy(0, 1, 3)), level.accuracy);
        RigidBody raft = pool.add(afloat(Polygon.box(4, 1), 0.3).at(0, 0.3));
        RigidBody load = pool.add(afloat(Polygon.box(1, 0.5), 0.4).at(0, 1.05));
        Scenes.run(pool, 3600);
        assertThat(raft.y()).isEqualTo(0.5 - 1.4 / 4, within(1e-6));
        assertThat(load.y() - raft.y()).isEqualTo(0.75, within(1e-6));
    }

    /** Bodies a thousand times lighter than the water they push away rise, and do not fly apart. */
    @Test
    void noWaterIsTooThick() {
        Pool pool =
                new Pool(
                        Scenes.usualWithoutSleep().with(new Buoyancy(0, 1000, 100)),
                        Accuracy.DRAFT);
        RigidBody cork = pool.add(afloat(new Circle(0.05), 1).at(1, -0.5));
        RigidBody other = pool.add(afloat(new Circle(0.05), 1).at(1.03, -0.41));
        for (int i = 0; i < 1200; i++) {
            assertThat(pool.step(Scenes.DT).quarantined()).isZero();
            // In water v = g/d; over it they may be thrown no farther than that carries them.
            assertThat(Math.abs(cork.velocityY())).isLessThan(2 * GRAVITY / 100);
            assertThat(Math.abs(other.velocityY())).isLessThan(2 * GRAVITY / 100);
        }
        assertThat(other.y()).isBetween(-0.41, 0.1);
    }
}
