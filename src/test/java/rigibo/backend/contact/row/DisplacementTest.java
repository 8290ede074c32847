package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

/** Random places, and a second set of random places. */
class DisplacementTest {

    private static final double ROUND_OFF = 1e-15;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final Displacement displacement = new Displacement(motions);

    private void place(SplittableRandom random) {
        for (int i = 0; i < motions.count * Motions.STRIDE; i++) {
            motions.data[i] = random.nextDouble(-1, 1);
        }
    }

    /** Places become x₀ + s·(x − x₀); velocities, masses and the ground stay. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 40})
    void displacementsAreScaled(int count) {
        SplittableRandom random = new SplittableRandom(count);
        island.begin(count);
        place(random);
        double[] before = motions.data.clone();
        displacement.begin();
        place(random);
        double[] after = motions.data.clone();
        for (int i = 0; i < (count + 1) * Motions.STRIDE; i++) {
            assertThat(displacement.of(i)).isEqualTo(after[i] - before[i]);
        }
        displacement.scaleAll(0.25);
        for (int i = 0; i < (count + 1) * Motions.STRIDE; i++) {
            int column = i % Motions.STRIDE;
            boolean isPlace = column >= Motions.DX && column <= Motions.TURN;
            boolean isScaled = isPlace && i >= Motions.STRIDE;
            double scaled = before[i] + 0.25 * (after[i] - before[i]);
            assertThat(motions.data[i]).isCloseTo(isScaled ? scaled : after[i], within(ROUND_OFF));
        }
    }

    @Test
    void oneBodyMayBeTakenBack() {
        island.begin(2);
        displacement.begin();
        for (int entry = 1; entry <= 2; entry++) {
            motions.data[entry * Motions.STRIDE + Motions.DY] = 1;
        }
        displacement.scale(2 * Motions.STRIDE, 0);
        assertThat(motions.data[Motions.STRIDE + Motions.DY]).isEqualTo(1);
        assertThat(motions.data[2 * Motions.STRIDE + Motions.DY]).isZero();
    }
}
