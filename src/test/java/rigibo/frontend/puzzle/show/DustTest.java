package rigibo.frontend.puzzle.show;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.scene.RecordingCanvas;

class DustTest {

    private static final double STEP = 1.0 / 60;

    /** A box as heavy as a RigiBo, 5 mm above the floor. */
    private static BodyDefinition box() {
        return BodyDefinition.dynamic(Polygon.box(1, 1))
                .at(0, 0.505)
                .material(Substance.RIGIBO.material());
    }

    /** Number of puffs of a box of 1 m that hits a floor at a speed, m/s. */
    private static int puffsAt(double speed) {
        Pool pool = new Pool();
        pool.add(BodyDefinition.fixed(Polygon.box(10, 1)).at(0, -0.5));
        pool.add(box().velocity(0, -speed));
        Dust dust = new Dust();
        for (int i = 0; i < 10; i++) {
            pool.step(STEP);
            dust.raise(pool);
        }
        RecordingCanvas canvas = new RecordingCanvas();
        dust.draw(canvas);
        return canvas.puffs();
    }

    @Test
    void aHardBlowRaisesMoreThanASoftOneAndATouchNone() {
        assertThat(puffsAt(0.1)).isZero();
        assertThat(puffsAt(1.5)).isPositive();
        assertThat(puffsAt(6)).isGreaterThan(puffsAt(1.5));
    }

    @Test
    void settlesWithinASecond() {
        Pool pool = new Pool();
        pool.add(BodyDefinition.fixed(Polygon.box(10, 1)).at(0, -0.5));
        pool.add(box().velocity(0, -3));
        Dust dust = new Dust();
        pool.step(STEP);
        dust.raise(pool);
        for (int i = 0; i < 60; i++) {
            dust.step();
        }
        RecordingCanvas canvas = new RecordingCanvas();
        dust.draw(canvas);
        assertThat(canvas.puffs()).isZero();
    }
}
