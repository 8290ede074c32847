package rigibo.lab.bench.large;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Gravity;

import java.util.List;

class LargeBenchTest {

    private static final int COUNT = 500;
    private static final double DT = 1.0 / 60;

    /**
     * Three fifths sleep in heaps, a fifth rolls as fast as it began, a fifth flies its parabola.
     */
    @Test
    void aWorldIsWhatItSays() {
        LargeWorld world = LargeWorld.of(COUNT);
        assertThat(world.bodies).hasSize(COUNT);
        RigidBody flyer = world.bodies.get(COUNT - 1);
        double begin = flyer.y();
        for (int step = 0; step < 120; step++) {
            world.pool.step(DT);
        }
        List<RigidBody> heaps = world.bodies.subList(0, COUNT * 3 / 5);
        assertThat(heaps).allMatch(body -> !body.isAwake());
        for (RigidBody disc : world.bodies.subList(COUNT * 3 / 5, COUNT * 4 / 5)) {
            // Nothing but round-off acts on a disc that rolls on a level floor.
            assertThat(disc.velocityX()).isCloseTo(2, within(1e-9));
        }
        // y = 20·t − g·t²/2, after 2 s, is exact in a step but for round-off at 5 km.
        double pull = world.pool.effects().find(Gravity.class).orElseThrow().y();
        double rise = 20 * 2 + pull * 2 * 2 / 2;
        assertThat(flyer.y() - begin).isCloseTo(rise, within(1e-9));
    }

    @Test
    void aWorldOfHeapsFallsAsleep() {
        LargeWorld world = LargeWorld.ofHeaps(4 * LargeWorld.HEAP);
        assertThat(world.bodies).hasSize(4 * LargeWorld.HEAP);
        for (int step = 0; step < 120; step++) {
            world.pool.step(DT);
        }
        assertThat(world.bodies).allMatch(body -> !body.isAwake());
    }

    @Test
    void costsAreToldByTheBody() {
        LargeCosts costs = new LargeCosts(1_000, 2e3, 5e6, 3e5, 4e5, 1e3, 7e6, 6e3, 90, 1_234.4);
        assertThat(LargeReport.of(List.of(costs)).markdown("By hand."))
                .contains("By hand.")
                .contains("| 1000 | 2.00 µs | 5.00 µs | 300 ns | 400 µs | 1.00 µs | 7.00 µs |")
                .contains("| 6.00 µs | 90.0 ns | 1234 B |");
    }
}
