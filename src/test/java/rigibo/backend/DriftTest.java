package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * Bodies too slow to leave their place in the sleep time, which nevertheless move on for ever,
 * since nothing resists them. The thresholds of sleep are 0.1 mm for a metre of width in half a
 * second.
 */
class DriftTest {

    private static final double DT = 1 / 60.0;
    private static final int STEPS = 1200;
    private static final Material SMOOTH = new Material(1000, 0, 0);

    private static RigidBody onFloor(Pool pool, BodyDefinition body, double v, double spin) {
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5).material(body.material()));
        return pool.add(body.at(0, 0.5).velocity(v, 0).spin(spin));
    }

    /** After a second on the floor, so that what landing does to the speed is over. */
    private static void requireDrift(Pool pool, RigidBody body) {
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        double from = body.x();
        double v = body.velocityX();
        for (int i = 0; i < STEPS; i++) {
            pool.step(DT);
        }
        assertThat(body.isAwake()).isTrue();
        assertThat(body.x() - from).isCloseTo(v * STEPS * DT, within(1e-3 * v * STEPS * DT));
    }

    @ParameterizedTest
    @ValueSource(doubles = {17e-6, 1e-6})
    void aBeadOnItsRailGoesOn(double v) {
        Pool pool = new Pool();
        BodyDefinition bead = BodyDefinition.dynamic(new Circle(0.5)).lockY().velocity(v, 0);
        requireDrift(pool, pool.add(bead));
    }

    /** It turns round within the time that would put it to sleep. */
    @Test
    void aBeadGoesOnFromTheWallThatItStruck() {
        Pool pool = new Pool();
        Material elastic = new Material(1000, 0, 1);
        double v = 17e-6;
        double gap = 3.75 * v;
        pool.add(BodyDefinition.fixed(Polygon.box(1, 1)).at(1 + gap, 0).material(elastic));
        RigidBody bead =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.5))
                                .lockY()
                                .velocity(v, 0)
                                .material(elastic));
        for (int i = 0; i < STEPS; i++) {
            pool.step(DT);
        }
        assertThat(bead.isAwake()).isTrue();
        assertThat(bead.velocityX()).isCloseTo(-v, within(1e-3 * v));
    }

    @ParameterizedTest
    @ValueSource(doubles = {17e-6, 1e-6})
    void whatSlidesOnASmoothFloorGoesOn(double v) {
        Pool pool = new Pool();
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1)).material(SMOOTH);
        requireDrift(pool, onFloor(pool, box, v, 0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {17e-6, 1e-6})
    void whatRollsGoesOn(double v) {
        Pool pool = new Pool();
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(0.5));
        requireDrift(pool, onFloor(pool, disc, v, -v / 0.5));
    }

    /** Friction ends what slides, and it sleeps half a second later. */
    @Test
    void whatFrictionHoldsSleeps() {
        Pool pool = new Pool();
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1));
        RigidBody body = onFloor(pool, box, 17e-6, 0);
        for (int i = 0; i < 60; i++) {
            pool.step(DT);
        }
        assertThat(body.isAwake()).isFalse();
    }
}
