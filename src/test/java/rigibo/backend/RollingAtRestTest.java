package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.Random;

/**
 * Discs with rolling resistance that lie on a crate, against which a plank leans, without sleep. A
 * torque of up to c·N holds them as friction holds what lies on a slope.
 */
class RollingAtRestTest {

    private static final int SCENES = 20;
    private static final int SECONDS = 15;
    private static final int FPS = 60;

    /** m/s: rows give way by 10⁻¹⁰ of what a body falls faster in a step. */
    private static final double GIVES_WAY = 1e-10 * 9.81 / FPS;

    private static final double PLANK = 0.1;

    private final Random random = new Random(1);

    private double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    private Pool scene(Preset preset) {
        Effects effects = Scenes.usualWithoutSleep().with(new RollingResistance());
        Material rough = new Material(between(0.5, 5), 0.7, 0).rollingResistance(0.01);
        Pool pool = new Pool(effects, preset.accuracy);
        double width = between(0.5, 1);
        double height = between(0.2, 0.5);
        double radius = between(0.15, 0.4);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5).material(rough));
        pool.add(crate(width, height).at(0, height / 2).material(rough));
        pool.add(
                BodyDefinition.dynamic(new Circle(radius))
                        .at(between(-0.1, 0.1), height + radius)
                        .material(rough));
        double angle = between(0.5, 0.9);
        double length = height / Math.sin(angle) * between(1.2, 1.6);
        double foot = -width / 2 - height / Math.tan(angle);
        double x = foot + (length * Math.cos(angle) - PLANK * Math.sin(angle)) / 2;
        double y = (length * Math.sin(angle) + PLANK * Math.cos(angle)) / 2;
        pool.add(crate(length, PLANK).at(x, y).angle(angle).material(rough));
        return pool;
    }

    private static BodyDefinition crate(double width, double height) {
        return BodyDefinition.dynamic(Polygon.box(width, height));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void discOnACrateComesToRest(Preset preset) {
        for (int i = 0; i < SCENES; i++) {
            Pool pool = scene(preset);
            Scenes.run(pool, SECONDS * FPS);
            for (int step = 0; step < FPS; step++) {
                pool.step(Scenes.DT);
                assertThat(fastest(pool)).as("scene %d", i).isLessThan(GIVES_WAY);
            }
        }
    }

    private static double fastest(Pool pool) {
        return pool.bodies().stream()
                .mapToDouble(body -> Math.hypot(body.velocityX(), body.velocityY()))
                .max()
                .orElseThrow();
    }
}
