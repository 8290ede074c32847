package rigibo.backend.contact;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Pool;
import rigibo.backend.PoolStorage;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.storage.DataStorage;

/** The number of substeps of a crowd, by the way of its fastest body in a step, in widths. */
class SubstepsTest {

    private static final int USUAL = 4;
    private static final double DT = 0.1;

    private final Pool pool =
            new Pool(
                    Effects.of(new Contacts(), new Rotation(), new Gravity(0, -9.81)),
                    Accuracy.GAME);

    /** Four tenths of a width need all substeps, and shares of it as large a share of them. */
    @ParameterizedTest
    @CsvSource({"0, 1", "0.09, 1", "0.11, 2", "0.21, 3", "0.31, 4", "0.5, 4", "50, 4"})
    void aCrowdHasSubstepsByItsFastestBody(double way, int substeps) {
        DataStorage data = wall(20);
        int last = data.islands.bodies[0];
        data.bodies.velocityX[last] = way / DT;
        assertThat(new Substeps(data).of(0, DT, USUAL)).isEqualTo(substeps);
    }

    /** The corner of a box of 1 m is √½ m from its centre. */
    @Test
    void turningIsAWayOfTheOutline() {
        DataStorage data = wall(20);
        data.bodies.spin[data.islands.bodies[0]] = 0.25 / DT / Math.sqrt(0.5);
        assertThat(new Substeps(data).of(0, DT, USUAL)).isEqualTo(3);
    }

    @Test
    void aFewBodiesHaveAllOfThem() {
        assertThat(new Substeps(wall(3)).of(0, DT, USUAL)).isEqualTo(USUAL);
    }

    /** The way of a body that was just pushed is not known yet. */
    @Test
    void aCrowdThatIsDrivenHasAllOfThem() {
        pool.add(BodyDefinition.kinematic(Polygon.box(1, 1)).at(-1, 0.5).velocity(1, 0));
        assertThat(new Substeps(wall(20)).of(0, DT, USUAL)).isEqualTo(USUAL);
    }

    /** Boxes side by side, three high, that have just been put there. */
    private DataStorage wall(int width) {
        pool.add(BodyDefinition.fixed(Polygon.box(100, 1)).at(0, -0.5));
        for (int storey = 0; storey < 3; storey++) {
            for (int i = 0; i < width; i++) {
                pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(i, storey + 0.5));
            }
        }
        pool.step(1e-6);
        DataStorage data = PoolStorage.of(pool);
        assertThat(data.islands.count).isEqualTo(1);
        return data;
    }
}
