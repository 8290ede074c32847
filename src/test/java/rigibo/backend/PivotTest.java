package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** A pillar that tips over its edge is a pendulum upside down. */
class PivotTest {

    private static final double G = 9.81;
    private static final double HALF_WIDTH = 0.2;
    private static final double HALF_HEIGHT = 1;
    private static final double SPIN = 1;

    /** Rough enough that the edge stays where it is until the pillar is past this angle, rad. */
    private static final Material ROUGH = new Material(1, 2, 0);

    private static final double UNTIL = 0.9;

    /**
     * A leapfrog takes an arc for its chord, which is off by (ωh)²/8 at either end of a substep;
     * the energy, a square, by four times that: a share (ωh)² of what moves. At DRAFT a turn of 2°
     * a step is none.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void pillarKeepsItsEnergyWhileItTips(Preset preset) {
        Pool pool = new Pool(Scenes.usualWithoutSleep(), preset.accuracy);
        RigidBody pillar = tippingPillar(pool);
        double h = Scenes.DT / preset.accuracy.substeps();
        double reach = Math.hypot(HALF_WIDTH, HALF_HEIGHT);
        double lean = Math.atan2(HALF_WIDTH, HALF_HEIGHT);
        pool.step(Scenes.DT);
        double energy = energy(pillar);
        while (pillar.angle() > -UNTIL) {
            pool.step(Scenes.DT);
            double turn = pillar.angularVelocity() * h;
            double error = turn * turn * pillar.kineticEnergy();
            assertThat(energy(pillar))
                    .as("at " + pillar.angle() + " rad")
                    .isEqualTo(energy, within(Math.max(error, 1e-6 * energy)));
            double height = reach * Math.cos(-pillar.angle() - lean);
            double bend = turn * turn / 2 * reach;
            assertThat(pillar.y()).isEqualTo(height, within(1e-5 * HALF_WIDTH + bend));
            assertThat(pillar.x())
                    .isEqualTo(reach * Math.sin(-pillar.angle() - lean), within(1e-3));
        }
    }

    private static RigidBody tippingPillar(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5).material(ROUGH));
        return pool.add(
                BodyDefinition.dynamic(Polygon.box(2 * HALF_WIDTH, 2 * HALF_HEIGHT))
                        .at(-HALF_WIDTH, HALF_HEIGHT)
                        .velocity(SPIN * HALF_HEIGHT, SPIN * HALF_WIDTH)
                        .spin(-SPIN)
                        .material(ROUGH));
    }

    private static double energy(RigidBody body) {
        return body.kineticEnergy() + body.mass() * G * body.y();
    }
}
