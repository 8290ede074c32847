package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * A body that may only turn, and a beater beside it that reaches into its place: where both ends of
 * a face are pressed on, no turning lets both give way, and it is thrown from one to the other in
 * no time.
 */
class WedgedTest {

    private static final double DT = 1 / 60.0;

    /** Of an instant without end, and one more for what is left. */
    private static final int ENDLESS = 65;

    /** What comes at its time, at both ends: each of GAME's four substeps ends 48 parts at most. */
    private static final int TIMED = 2 * 4 * 48;

    /** Corners of the beater. */
    private static final int CORNERS = 5;

    /** Times that a corner strikes an elastic body as it passes: either end, and either again. */
    private static final int IF_ELASTIC = 4;

    @ParameterizedTest(name = "{0} rad/s, elasticity {1}")
    @CsvSource({
        "50, 0",
        "50, 0.5",
        "50, 1",
        "200, 0",
        "200, 0.5",
        "200, 1",
        "1000, 0",
        "1000, 0.5",
        "1000, 1",
        "10000, 0",
        "10000, 0.5",
        "10000, 1"
    })
    void isStruckNoMoreOftenThanOnceWithoutEnd(double spin, double elasticity) {
        Pool pool = new Pool(Effects.usual().without(Sleep.class), Accuracy.GAME);
        Material material = new Material(1000, 0.5, elasticity);
        RigidBody body =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .at(1.05, 0)
                                .material(material)
                                .lockX()
                                .lockY());
        pool.add(
                BodyDefinition.kinematic(Polygon.regular(CORNERS, 0.6))
                        .spin(spin)
                        .material(material));
        double passing = elasticity == 1 ? IF_ELASTIC * CORNERS * spin * DT / (2 * Math.PI) : 0;
        for (int i = 0; i < 120; i++) {
            double most = ENDLESS + TIMED + passing;
            assertThat((double) pool.step(DT).impacts()).isLessThanOrEqualTo(most);
        }
        assertThat(body.x()).isEqualTo(1.05);
        assertThat(body.y()).isZero();
    }
}
