package rigibo.lab.bench.probe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.bench.scene.Pace;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.child.Work;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

import java.util.List;
import java.util.stream.IntStream;

class BenchProbeTest {

    private static final BodyDefinition FLOOR = BodyDefinition.fixed(Polygon.box(10, 1)).at(0, 0.5);
    private static final BodyDefinition BOX = BodyDefinition.dynamic(Polygon.box(1, 1));
    private static final BodyDefinition DISC = BodyDefinition.dynamic(new Circle(0.25));
    private static final Effects FALLING = Effects.of(new Gravity(0, -10));

    private static double overlap(BodyDefinition... bodies) {
        Scene scene = new Scene(FALLING, List.of(bodies));
        try (World world = RigiBoEngine.world(FALLING, Accuracy.GAME)) {
            scene.build(world);
            return DeepestOverlap.in(scene, world);
        }
    }

    @Test
    void overlapIsOfTheDeepestPairFromWhereBodiesAre() {
        assertThat(overlap(DISC.at(0, 0), DISC.at(0.4, 0), DISC.at(5, 5)))
                .isCloseTo(0.1, within(1e-12));
        assertThat(overlap(FLOOR, BOX.at(2, 1.3), DISC.at(-2, 1.2))).isCloseTo(0.2, within(1e-12));
        assertThat(overlap(FLOOR, BOX.at(2, 1.5001), DISC.at(-2, 1.3))).isZero();
        assertThat(overlap(FLOOR, FLOOR.at(0.5, 0.5))).as("neither gives way").isZero();
    }

    /** m·(v²/2 + g·h) + I·ω²/2 with m = 1, h = 2 m over the floor, I = 1/6 of the box. */
    @Test
    void heightAndEnergyCountFromTheGroundBelow() {
        Scene scene = new Scene(FALLING, List.of(FLOOR, BOX.at(0, 3).velocity(3, 4).spin(6)));
        try (World world = RigiBoEngine.world(FALLING.with(new Rotation()), Accuracy.GAME)) {
            scene.build(world);
            Look look = Look.at(scene, world);
            assertThat(look.height()).isEqualTo(2);
            assertThat(look.energy()).isCloseTo(12.5 + 20 + 3, within(1e-12));
        }
    }

    @Test
    void bodyBesideTheFloorStandsOverZero() {
        assertThat(Grounds.below(List.of(FLOOR, BOX.at(0, 3), BOX.at(6, 3), BOX.at(0, 0.5))))
                .containsExactly(0, 1, 0, 0);
    }

    @Test
    void percentilesAreByTheNearestRank() {
        StepTimes ten = downFrom(10);
        assertThat(ten.median()).isEqualTo(5);
        assertThat(ten.p99()).isEqualTo(10);
        StepTimes more = downFrom(200);
        assertThat(more.median()).isEqualTo(100);
        assertThat(more.p99()).isEqualTo(198);
        assertThat(more.mean()).isEqualTo(100.5);
        assertThat(more.max()).isEqualTo(200);
    }

    private static StepTimes downFrom(int count) {
        return new StepTimes(IntStream.range(0, count).mapToDouble(i -> count - i).toArray());
    }

    /** Free flight by exact parabolas keeps its energy; 10 s down from 1 km: 500 m of 1,000. */
    @Test
    void measuresASmallSceneToItsEnd() {
        Scene scene = new Scene(FALLING, List.of(BOX.at(0, 1000)));
        Sample sample = BenchProbe.measure(new RigiBoEngine(), scene, new Pace(0.01, 540, 60));
        assertThat(sample.steps()).isEqualTo(60);
        assertThat(sample.median()).isPositive().isLessThanOrEqualTo(sample.p99());
        assertThat(sample.height()).isCloseTo(0.5, within(1e-9));
        assertThat(sample.energy()).isCloseTo(1, within(1e-9));
        assertThat(sample.overlap()).isZero();
        assertThat(sample.work()).isEqualTo(Work.NONE);
    }
}
