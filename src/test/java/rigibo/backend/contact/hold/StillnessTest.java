package rigibo.backend.contact.hold;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.OwnLoads;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.KeptOverlap;

/**
 * A body of 2 kg, half a metre wide, on the ground under 10 m/s², whose contact carries 3 N·s. In a
 * kick of 0.2 s its own loads are 2 m/s of pull and 1.5 m/s of support.
 */
class StillnessTest {

    private static final double H = 0.1;
    private static final int SUBSTEPS = 4;
    private static final double KICK = 0.2;
    private static final double WIDTH = 0.5;
    private static final double RADIUS = 0.7;
    private static final double OWN = 3.5;

    /** Speed of a creep of 10⁻⁹ widths in a step of four substeps, m/s. */
    private static final double CREEP = Stillness.STILL * WIDTH / (SUBSTEPS * H);

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final OwnLoads own = new OwnLoads(bodies, motions, contacts);
    private final Kick kick = new Kick(bodies, motions, null, null, null);
    private final Stillness stillness = new Stillness(bodies, motions, contacts, own, null, kick);
    private int row;

    @BeforeEach
    void lay() {
        bodies.smallestWidth[0] = WIDTH;
        bodies.boundingRadius[0] = RADIUS;
        bodies.accelerationY[0] = -10;
        island.begin(1);
        island.body(1, 0.5, 1);
        row = island.onGround(1, 0.5, 0.5);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = 1;
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE1] = 2;
        stillness.begin();
    }

    private void go(double x, double y, double spin) {
        motions.data[Motions.STRIDE + Motions.VX] = x;
        motions.data[Motions.STRIDE + Motions.VY] = y;
        motions.data[Motions.STRIDE + Motions.SPIN] = spin;
    }

    private double speedY() {
        return motions.data[Motions.STRIDE + Motions.VY];
    }

    private boolean isAtRest() {
        return stillness.isAtRest(0, H, SUBSTEPS, KICK);
    }

    /**
     * A tenth of 10 m/s² for 0.4 s is 0.4 m/s, for the larger component, added to the speed of the
     * rim.
     */
    @ParameterizedTest
    @CsvSource({
        "0.39, -0.39, 0, true",
        "0.41, 0, 0, false",
        "0, -0.41, 0, false",
        "0.2, 0, 0.28, true",
        "0.2, 0, -0.29, false"
    })
    void stillIsMeasuredByThePull(double x, double y, double spin, boolean isStill) {
        go(x, y, spin);
        assertThat(stillness.isEveryBodyStill(0.4, 0.1)).isEqualTo(isStill);
    }

    /** Without a pull, a creep by 10⁻⁹ widths counts as still. */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false"})
    void creepIsStill(double times, boolean isStill) {
        bodies.accelerationY[0] = 0;
        go(times * CREEP, 0, 0);
        assertThat(stillness.isEveryBodyStill(SUBSTEPS * H, 0.1)).isEqualTo(isStill);
    }

    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false", "-0.99, true", "-1.01, false"})
    void whatMovesDoesNotRest(double times, boolean rests) {
        go(0, times * CREEP, 0);
        assertThat(isAtRest()).isEqualTo(rests);
    }

    /** In a long step the body must creep more slowly; a weak kick leaves less. */
    @Test
    void whatIsLeftOfAKickIsMeasuredByItsLoads() {
        bodies.smallestWidth[0] = 1e3;
        go(0, 0.99 * Stillness.UNHELD * OWN, 0);
        assertThat(isAtRest()).isTrue();
        go(0, 1.01 * Stillness.UNHELD * OWN, 0);
        assertThat(isAtRest()).isFalse();
        // Motion from before the kick is not left by it.
        stillness.begin();
        assertThat(isAtRest()).isTrue();
    }

    @Test
    void whatIsDrivenRunsOrJoinsDoesNotRest() {
        assertThat(isAtRest()).isTrue();
        motions.isAnyDriven = true;
        assertThat(isAtRest()).isFalse();
        motions.isAnyDriven = false;
        contacts.isAnyRunning = true;
        assertThat(isAtRest()).isFalse();
        contacts.isAnyRunning = false;
        contacts.lastJoining = 0;
        assertThat(isAtRest()).isFalse();
    }

    /** Overlap that is being removed moves bodies; kept overlap does not. */
    @Test
    void whatIsMovedApartDoesNotRest() {
        OverlapSolver overlap = new OverlapSolver(bodies, motions, contacts, Accuracy.GAME);
        Stillness correcting = new Stillness(bodies, motions, contacts, own, overlap, kick);
        correcting.begin();
        int at = row * PackedContacts.STRIDE;
        contacts.data[at + PackedContacts.RECOVERY] = Recovery.RATE;
        contacts.data[at + PackedContacts.GAP0] = -0.9 * KeptOverlap.LEAST;
        overlap.prepare(true);
        assertThat(correcting.isAtRest(0, H, SUBSTEPS, KICK)).isTrue();
        contacts.data[at + PackedContacts.GAP0] = -1.1 * KeptOverlap.LEAST;
        assertThat(correcting.isAtRest(0, H, SUBSTEPS, KICK)).isFalse();
    }

    /** The rest of a kick's loads is halted; earlier motion goes on. */
    @Test
    void whatIsHeldIsHalted() {
        go(0, 0.99 * Stillness.UNHELD * OWN, 0);
        stillness.haltHeld(KICK);
        assertThat(speedY()).isZero();
        double fast = 1.01 * Stillness.UNHELD * OWN;
        go(0, fast, 0);
        stillness.haltHeld(KICK);
        assertThat(speedY()).isEqualTo(fast);
        stillness.begin();
        stillness.haltHeld(KICK);
        assertThat(speedY()).isEqualTo(fast);
    }

    /** A body that was struck meanwhile is not halted, however slow it is. */
    @Test
    void whatWasMovedByTheKickIsNotHalted() {
        double slow = 0.5 * Stillness.UNHELD * OWN;
        go(0, -1, 0);
        stillness.begin();
        go(0, slow, 0);
        stillness.haltHeld(KICK);
        assertThat(speedY()).isEqualTo(slow);
    }
}
