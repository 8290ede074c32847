package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

class ChatterTest {

    /**
     * The face of a heavy box that spins at ω, d = 0.4 m from its centre, strikes a light disc
     * beside the foot of that distance by s: the disc leaves at ωs, and the face is back after
     * 2s/(dω), some hundred times in a step. Impacts without loss keep the energy, and momentum is
     * what it was, both to round-off of so many impacts.
     */
    @ParameterizedTest(name = "a face that spins at {0} rad/s, struck {1} m beside its middle")
    @CsvSource({"100, 0.001", "100, 0.004", "40, 0.001", "200, 0.01"})
    void turningFaceThatStrikesWithoutLossKeepsTheEnergy(double spin, double beside) {
        Pool pool = new Pool(Effects.usual().without(Gravity.class), Accuracy.GAME);
        Material elastic = new Material(1, 0, 1);
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(0.8, 0.8)).spin(spin).mass(100);
        pool.add(box.material(elastic));
        RigidBody disc =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.05))
                                .at(beside, 0.45 + 1e-6)
                                .mass(1e-3)
                                .material(elastic));
        double start = pool.kineticEnergy();
        int most = 0;
        for (int step = 0; step < 60; step++) {
            most = Math.max(most, pool.step(1.0 / 60).impacts());
        }
        assertThat(most).as("impacts in a step").isGreaterThan(16);
        double offset = 1e-8 * disc.kineticEnergy();
        assertThat(pool.kineticEnergy()).isCloseTo(start, Offset.offset(offset));
        assertThat(Math.hypot(pool.momentumX(), pool.momentumY()))
                .isLessThan(1e-9 * disc.mass() * Math.hypot(disc.velocityX(), disc.velocityY()));
    }
}
