package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** Pyramids built with equal vertical gaps, whose storeys land on each other. */
class SettlingPyramidTest {

    /**
     * Share of the energy at the start that a step may gain at {@code EXACT}: what is lifted out of
     * overlaps of some ten-thousandths of a width, which elimination leaves where it finds no end.
     */
    private static final double GAINED = 1e-6;

    /** Impacts and friction take energy, weights only change it from height to motion. */
    @ParameterizedTest
    @CsvSource({"4, 0.01", "5, 0.003", "6, 0.01", "6, 0.005", "6, 0.015", "6, 0.02"})
    void storeysThatLandGainNoEnergy(int base, double gap) {
        Pool pool = new Pool(Scenes.usualWithoutSleep(), Accuracy.EXACT);
        Material stone = new Material(1, 0.6, 0.1);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 2)).at(0, -1).material(stone));
        for (int row = 0; row < base; row++) {
            for (int i = 0; i < base - row; i++) {
                double y = row + 0.5 + gap * (row + 1);
                BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1)).material(stone);
                pool.add(box.at(i - (base - row - 1) / 2.0, y));
            }
        }
        double start = pool.kineticEnergy() + pool.potentialEnergy();
        double before = start;
        for (int step = 1; step <= 60; step++) {
            pool.step(Scenes.DT);
            double now = pool.kineticEnergy() + pool.potentialEnergy();
            assertThat((now - before) / start).as("gained in step %d", step).isLessThan(GAINED);
            before = now;
        }
    }
}
