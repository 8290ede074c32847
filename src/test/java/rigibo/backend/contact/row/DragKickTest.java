package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.storage.Bodies;

/** v′ = a − k·v is v = v₀·e^(−kt) + a/k·(1 − e^(−kt)), with velocities in the world's frame. */
class DragKickTest {

    private static final double ROUND_OFF = 1e-14;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Drag()));
    private final DragKick kick = new DragKick(bodies, motions);
    private final double[] lengths = new double[4 * Motions.STRIDE];

    private void lay(double drag) {
        island.begin(3);
        for (int entry = 1; entry <= 3; entry++) {
            island.body(entry, entry < 3 ? 0.5 : 0, 1);
            motions.slots[entry] = entry;
            bodies.drag[entry] = drag;
            bodies.accelerationX[entry] = 2;
            bodies.accelerationY[entry] = -10;
            motions.data[entry * Motions.STRIDE + Motions.VX] = 3;
            motions.data[entry * Motions.STRIDE + Motions.VY] = 4;
        }
        bodies.pileTime[2] = 0.3;
    }

    private double velocity(int entry, int column) {
        return motions.data[entry * Motions.STRIDE + column];
    }

    @Test
    void velocityDecaysAsTheEquationSays() {
        lay(5);
        motions.takeFrame(0.7, -0.2);
        kick.accelerate(0.2, 0.6, lengths);
        for (int entry = 1; entry <= 2; entry++) {
            double t = entry == 1 ? 0.4 : 0.3;
            double left = Math.exp(-5 * t);
            double x = 3.7 * left + 2 / 5.0 * (1 - left) - 0.7;
            double y = 3.8 * left - 10 / 5.0 * (1 - left) + 0.2;
            assertThat(velocity(entry, Motions.VX)).isCloseTo(x, within(ROUND_OFF));
            assertThat(velocity(entry, Motions.VY)).isCloseTo(y, within(ROUND_OFF));
            assertThat(lengths[entry * Motions.STRIDE + Kick.LENGTH])
                    .isCloseTo(t, within(ROUND_OFF));
        }
        assertThat(velocity(3, Motions.VX)).isEqualTo(3);
        assertThat(lengths[3 * Motions.STRIDE + Kick.LENGTH]).isZero();
    }

    @Test
    void withoutDragItGrowsByTheAcceleration() {
        lay(0);
        kick.accelerate(0.2, 0.6, lengths);
        assertThat(velocity(1, Motions.VX)).isCloseTo(3 + 2 * 0.4, within(ROUND_OFF));
        assertThat(velocity(1, Motions.VY)).isCloseTo(4 - 10 * 0.4, within(ROUND_OFF));
        assertThat(velocity(2, Motions.VY)).isCloseTo(4 - 10 * 0.3, within(ROUND_OFF));
        kick.accelerate(0.1, 0.3, lengths);
        assertThat(velocity(2, Motions.VY)).isCloseTo(4 - 10 * 0.3, within(ROUND_OFF));
    }
}
