package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.storage.Bodies;

/**
 * Two bodies, of 1 kg and of 3 kg, that recovery moves in a hundredth of a second. Under a pull of
 * 10 m/s² they would fall by 0.5 mm in it, and they may be lifted by twice as far on average.
 */
class LiftLimitTest {

    private static final double H = 0.01;
    private static final double FALL = 5e-4;
    private static final double MASS = 3;

    /** Angle in rad between the pull and straight down: no axis is special. */
    private static final double LEANS = 0.3;

    private static final double UP_X = -Math.sin(LEANS);
    private static final double UP_Y = Math.cos(LEANS);
    private static final double ROUND_OFF = 1e-15;

    private final Bodies bodies = new Bodies(Effects.of(new Contacts()));
    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final LiftLimit limit = new LiftLimit(bodies, motions);

    @BeforeEach
    void begin() {
        bodies.accelerationX[0] = -10 * UP_X;
        bodies.accelerationY[0] = -10 * UP_Y;
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 1 / MASS, 0);
        limit.begin();
    }

    @Test
    void whatIsLiftedByLittleGoesAllTheWay() {
        lift(1, 3.9 * FALL);
        lift(2, 1.3 * FALL);
        limit.end(H);
        assertThat(lifted(1)).isCloseTo(3.9 * FALL, within(ROUND_OFF));
        assertThat(lifted(2)).isCloseTo(1.3 * FALL, within(ROUND_OFF));
    }

    /**
     * The energy of the lift is that of two falls, and all bodies move by the same share of their
     * way.
     */
    @Test
    void whatIsLiftedByMuchIsHeldBack() {
        lift(1, 10 * FALL);
        lift(2, 30 * FALL);
        limit.end(H);
        double energy = lifted(1) + MASS * lifted(2);
        assertThat(energy).isCloseTo(2 * FALL * (1 + MASS), within(ROUND_OFF));
        assertThat(lifted(2)).isCloseTo(3 * lifted(1), within(ROUND_OFF));
    }

    @Test
    void whatGoesAsideOrDownIsNotHeldBack() {
        motions.data[Motions.STRIDE + Motions.DX] = UP_Y;
        motions.data[Motions.STRIDE + Motions.DY] = -UP_X;
        lift(2, -1);
        limit.end(H);
        assertThat(motions.data[Motions.STRIDE + Motions.DX]).isEqualTo(UP_Y);
        assertThat(lifted(2)).isCloseTo(-1, within(ROUND_OFF));
    }

    private void lift(int entry, double by) {
        motions.data[entry * Motions.STRIDE + Motions.DX] = by * UP_X;
        motions.data[entry * Motions.STRIDE + Motions.DY] = by * UP_Y;
    }

    private double lifted(int entry) {
        int at = entry * Motions.STRIDE;
        return motions.data[at + Motions.DX] * UP_X + motions.data[at + Motions.DY] * UP_Y;
    }
}
