package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.storage.Bodies;

/**
 * A body of 2 kg and 4 kg·m² on the ground, at (3, 4) m/s and 2 rad/s: its kinetic energy is 33 J,
 * of which a hundredth may be taken.
 */
class EnergyBalanceTest {

    private static final double MOTION = 33;
    private static final double ROUND_OFF = 1e-12;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final DenseRows dense = new DenseRows(island);
    private final Bodies bodies =
            new Bodies(Effects.of(new Contacts(), new Rotation(), new Drag()));
    private final EnergyBalance balance = new EnergyBalance(bodies, motions, island.contacts);

    @BeforeEach
    void lay() {
        bodies.integratePaths(true);
        island.begin(1);
        island.body(1, 0.5, 0.25);
        island.onGround(1, 0.5, 0.5);
        bodies.accelerationX[0] = 1;
        bodies.accelerationY[0] = -10;
        bodies.angularAcceleration[0] = 3;
        go(3, 4, 2);
        balance.begin();
    }

    private void go(double x, double y, double spin) {
        motions.data[Motions.STRIDE + Motions.VX] = x;
        motions.data[Motions.STRIDE + Motions.VY] = y;
        motions.data[Motions.STRIDE + Motions.SPIN] = spin;
    }

    private void move(double x, double y, double turn) {
        motions.data[Motions.STRIDE + Motions.DX] = x;
        motions.data[Motions.STRIDE + Motions.DY] = y;
        motions.data[Motions.STRIDE + Motions.TURN] = turn;
    }

    /**
     * The work is m·a·d and I·α·δ; a gain beyond it is removed, and the direction and the spin's
     * sign stay.
     */
    @ParameterizedTest
    @CsvSource({"0.01, 0, 0, 0.02", "0, -0.001, 0, 0.02", "0, 0, 0.002, 0.024", "0, 0, 0, 0"})
    void whatWasGainedWithoutWorkIsTaken(double x, double y, double turn, double work) {
        double gained = 0.01;
        double faster = Math.sqrt((MOTION + work + gained) / MOTION);
        move(x, y, turn);
        go(3 * faster, 4 * faster, 2 * faster);
        balance.settle();
        assertThat(dense.energy()).isCloseTo(MOTION + work, within(ROUND_OFF * MOTION));
        double[] now = dense.velocities();
        assertThat(now[3] / now[4]).isCloseTo(0.75, within(ROUND_OFF));
        assertThat(now[3] / now[5]).isCloseTo(1.5, within(ROUND_OFF));
    }

    @Test
    void whatWasLostIsNotGiven() {
        go(2.9, 4, 2);
        balance.settle();
        assertThat(dense.velocities()[3]).isEqualTo(2.9);
        // Lifted by 1 mm against its weight, it should have lost 0.02 J.
        go(3, 4, 2);
        move(0, 0.001, 0);
        balance.settle();
        assertThat(dense.energy()).isCloseTo(MOTION - 0.02, within(ROUND_OFF * MOTION));
    }

    /** A body that rests in an overlap has no energy to give: a hundredth at most. */
    @Test
    void littleIsTakenAtATime() {
        move(0, 0.1, 0);
        balance.settle();
        assertThat(dense.energy()).isCloseTo(0.99 * MOTION, within(ROUND_OFF * MOTION));
    }

    @Test
    void bodiesAreNotSlowedInSpace() {
        island.contacts.groundStart = island.contacts.count;
        move(0, 0.1, 0);
        balance.settle();
        assertThat(dense.energy()).isCloseTo(MOTION, within(ROUND_OFF));
    }

    /** If other effects do work, its amount is unknown. */
    @ParameterizedTest
    @CsvSource({"driven", "running", "pull x", "pull y", "drag", "crowd"})
    void whatIsNotKnownIsNotBalanced(String what) {
        motions.isAnyDriven = what.equals("driven");
        island.contacts.isAnyRunning = what.equals("running");
        bodies.pullX[0] = what.equals("pull x") ? 1 : 0;
        bodies.pullY[0] = what.equals("pull y") ? 1 : 0;
        bodies.drag[0] = what.equals("drag") ? 1 : 0;
        if (what.equals("crowd")) {
            // There are more bodies than are followed one by one.
            motions.count = 6;
        }
        balance.begin();
        motions.count = 2;
        move(0, 0.1, 0);
        balance.settle();
        assertThat(dense.energy()).isCloseTo(MOTION, within(ROUND_OFF));
        motions.isAnyDriven = false;
    }
}
