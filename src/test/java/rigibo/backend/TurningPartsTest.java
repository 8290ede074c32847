package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.SplittableRandom;

/**
 * A box of two halves that turns by up to two turns within a step. At the start the half above lies
 * in the seam to the other; whichever half comes down first, none goes through the floor.
 */
@Execution(ExecutionMode.CONCURRENT)
class TurningPartsTest {

    private static final double DT = 1.0 / 60;
    private static final int DRAWS = 200;

    /** Stopping gaps keep bodies apart; places of order 1 m are exact to 10⁻¹⁵ m. */
    private static final double ROUND_OFF = 1e-12;

    private static final Compound HALVES =
            Compound.of(
                    Part.of(Polygon.box(1, 0.5)).at(0, 0.25),
                    Part.of(Polygon.box(1, 0.5)).at(0, -0.25));

    @Test
    void noHalfGoesThroughTheFloor() {
        SplittableRandom random = new SplittableRandom(1);
        int struck = 0;
        for (int i = 0; i < DRAWS; i++) {
            Pool pool =
                    new Pool(
                            Effects.of(
                                    new Contacts(),
                                    new ContinuousImpacts(),
                                    new Rotation(),
                                    new Restitution()),
                            Accuracy.GAME);
            pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
            RigidBody box =
                    pool.add(
                            BodyDefinition.dynamic(HALVES)
                                    .at(0, 1)
                                    .velocity(0, -60 * random.nextDouble())
                                    .spin(1500 * random.nextDouble() - 750)
                                    .material(new Material(1, 0, 1)));
            double energy = pool.kineticEnergy();
            pool.step(DT);
            struck += pool.report().impacts() > 0 ? 1 : 0;
            assertThat(lowest(box)).as("draw " + i).isGreaterThan(-ROUND_OFF);
            assertThat(pool.kineticEnergy() / energy - 1).as("draw " + i).isBetween(-1e-12, 1e-12);
        }
        assertThat(struck).isGreaterThan(DRAWS / 3);
    }

    /** Height of the lowest corner of the box, m. */
    private static double lowest(RigidBody box) {
        double cos = Math.abs(Math.cos(box.angle()));
        double sin = Math.abs(Math.sin(box.angle()));
        return box.y() - (cos + sin) / 2;
    }
}
