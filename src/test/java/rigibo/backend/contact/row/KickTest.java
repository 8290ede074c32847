package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.storage.Bodies;

/** Two bodies of 2 kg and ½ kg in slots of their own; the second joined after 0.1 s. */
class KickTest {

    private static final double ROUND_OFF = 1e-14;

    private final PackedIsland island = new PackedIsland();
    private final DenseRows dense = new DenseRows(island);
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final PackedTurns turns = new PackedTurns(bodies, island.motions);
    private final Kick kick = new Kick(bodies, island.motions, null, null, turns);

    @BeforeEach
    void lay() {
        island.begin(3);
        island.body(1, 0.5, 1);
        island.body(2, 2, 1);
        island.body(3, 0, 0);
        for (int entry = 1; entry <= 3; entry++) {
            island.motions.slots[entry] = entry;
            bodies.accelerationX[entry] = entry;
            bodies.accelerationY[entry] = -10;
            bodies.angularAcceleration[entry] = 4;
        }
        bodies.pileTime[2] = 0.1;
    }

    /** v += a·t. A body that joined meanwhile is kicked from then on, a driven body never. */
    @Test
    void velocitiesGrowByTheirAccelerations() {
        kick.remember();
        kick.accelerate(0, 0.25);
        double[] truth = {0, 0, 0, 0.25, -2.5, 1, 0.3, -1.5, 0.6, 0, 0, 0};
        assertThat(dense.velocities()).containsExactly(truth, within(ROUND_OFF));
        assertThat(kick.length(Motions.STRIDE)).isEqualTo(0.25);
        assertThat(kick.length(2 * Motions.STRIDE)).isCloseTo(0.15, within(ROUND_OFF));
        assertThat(kick.length(3 * Motions.STRIDE)).isZero();
        kick.accelerate(0.25, 0.25);
        assertThat(dense.velocities()).containsExactly(truth, within(ROUND_OFF));
    }

    /** A body is not kicked before it has joined. */
    @Test
    void whatHasNotJoinedIsNotKicked() {
        kick.remember();
        kick.accelerate(0, 0.05);
        assertThat(dense.velocities()[6]).isZero();
        assertThat(dense.velocities()[7]).isZero();
        assertThat(dense.velocities()[8]).isZero();
        assertThat(kick.length(2 * Motions.STRIDE)).isZero();
    }

    /** Impulses of contacts since then count in the gain per second of the kick. */
    @Test
    void gainIsMeasuredPerSecondOfTheKick() {
        island.motions.data[Motions.STRIDE + Motions.VX] = 7;
        kick.remember();
        kick.accelerate(0, 0.25);
        island.motions.data[Motions.STRIDE + Motions.VY] += 2;
        island.motions.data[Motions.STRIDE + Motions.SPIN] -= 1;
        kick.measureGain();
        assertThat(kick.gained(Motions.STRIDE, Motions.VX)).isCloseTo(1, within(ROUND_OFF));
        assertThat(kick.gained(Motions.STRIDE, Motions.VY)).isCloseTo(-2, within(1e-13));
        assertThat(kick.gained(Motions.STRIDE, Motions.SPIN)).isCloseTo(0, within(1e-13));
        assertThat(kick.gained(3 * Motions.STRIDE, Motions.VY)).isZero();
    }

    /** The greatest component of the accelerations, and Σ m·a²·h²/2 of all movable bodies. */
    @Test
    void strengthAndEnergyOfAKick() {
        assertThat(kick.strongest()).isEqualTo(10);
        bodies.accelerationX[2] = -11;
        assertThat(kick.strongest()).isEqualTo(11);
        double truth = (2 * (1 + 100) + 0.5 * (121 + 100)) * 0.01 / 2;
        assertThat(kick.energy(0.1)).isCloseTo(truth, within(1e-13));
    }

    @Test
    void constantPullsAreSteady() {
        assertThat(kick.mayChange()).isFalse();
        assertThat(kick.isForced()).isFalse();
        assertThat(kick.isSteady(0, 0.1, 4, 0)).isTrue();
    }

    /** Spins and inertias are packed from the columns and written back. */
    @Test
    void turningIsPackedAndStored() {
        bodies.spin[2] = 5;
        bodies.inverseInertia[2] = 6;
        bodies.type[1] = rigibo.backend.setup.BodyType.STATIC;
        bodies.type[2] = rigibo.backend.setup.BodyType.DYNAMIC;
        bodies.type[3] = rigibo.backend.setup.BodyType.KINEMATIC;
        turns.pack(2);
        int at = 2 * Motions.STRIDE;
        assertThat(island.motions.data[at + Motions.SPIN]).isEqualTo(5);
        assertThat(island.motions.data[at + Motions.INVERSE_INERTIA]).isEqualTo(6);
        assertThat(island.motions.data[Motions.STRIDE + Motions.INVERSE_INERTIA]).isEqualTo(1);
        island.motions.data[at + Motions.SPIN] = 8;
        island.motions.data[at + Motions.TURN] = 0.5;
        island.motions.data[3 * Motions.STRIDE + Motions.SPIN] = 8;
        bodies.cos[2] = 1;
        turns.store();
        assertThat(bodies.spin[2]).isEqualTo(8);
        assertThat(bodies.spin[3]).isZero();
        assertThat(bodies.angle[2]).isEqualTo(0.5);
        assertThat(bodies.sin[2]).isCloseTo(Math.sin(0.5), within(1e-12));
    }
}
