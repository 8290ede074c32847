package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Islands;

import java.util.Arrays;

/**
 * Bodies that join within a step of substeps of 0.1 s: body 1 at its start, body 2 after 0.37 s.
 */
class LateJoinersTest {

    private static final double H = 0.1;
    private static final double LATE = 0.37;
    private static final double ROUND_OFF = 1e-15;

    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final LateJoiners joiners = new LateJoiners(bodies, motions, contacts);

    @BeforeEach
    void lay() {
        lay(3);
    }

    private void lay(int count) {
        island.begin(count);
        for (int entry = 1; entry <= count; entry++) {
            int slot = entry % 16;
            island.body(entry, 1, 1);
            motions.slots[entry] = slot;
            bodies.type[slot] = BodyType.DYNAMIC;
            bodies.velocityX[slot] = 2;
            bodies.accelerationX[slot] = 4;
            bodies.accelerationY[slot] = -10;
            bodies.angularAcceleration[slot] = 6;
            set(entry, Motions.VX, 2);
            set(entry, Motions.VY, -3);
            set(entry, Motions.SPIN, 5);
        }
        bodies.type[3] = BodyType.KINEMATIC;
        bodies.pileTime[2] = LATE;
        island.contact(0, 1, 0.5, 0.5);
        island.contact(1, 2, 0.5, 0.5);
        island.contact(2, 3, 0.5, 0.5);
        for (int row = 0; row < 3; row++) {
            contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = 1;
        }
    }

    private void set(int entry, int column, double value) {
        motions.data[entry * Motions.STRIDE + column] = value;
    }

    private double of(int entry, int column) {
        return motions.data[entry * Motions.STRIDE + column];
    }

    private double impulse(int row) {
        return contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0];
    }

    @Test
    void islandStartsWithItsFirstBody() {
        Islands islands = new Islands();
        islands.bodyStart = new int[] {0, 1, 3};
        islands.bodies = new int[] {1, 4, 2};
        bodies.pileTime[4] = 0.4;
        assertThat(joiners.startOf(islands, 0)).isZero();
        assertThat(joiners.startOf(islands, 1)).isEqualTo(LATE);
    }

    /** At 2 m/s the body is at its joining place when it joins, 0.27 s after the island's start. */
    @Test
    void bodyGoesStraightToWhereItJoins() {
        joiners.delay(0.1, H);
        assertThat(of(2, Motions.DX)).isCloseTo(-0.27 * 2, within(ROUND_OFF));
        assertThat(of(2, Motions.DY)).isCloseTo(0.27 * 3, within(ROUND_OFF));
        assertThat(of(2, Motions.TURN)).isCloseTo(-0.27 * 5, within(ROUND_OFF));
        assertThat(of(1, Motions.DX)).isZero();
        // A driven body is at its place of the step's start, 0.1 s before.
        assertThat(of(3, Motions.DX)).isCloseTo(0.1 * 2, within(ROUND_OFF));
        assertRowsJoinIn(2);
    }

    private void assertRowsJoinIn(int substep) {
        assertThat(contacts.firstSubstep[0]).isEqualTo(PackedContacts.ALWAYS);
        assertThat(contacts.firstSubstep[1]).isEqualTo(substep);
        assertThat(contacts.firstSubstep[2]).isEqualTo(substep);
        assertThat(contacts.lastJoining).isEqualTo(substep);
        assertThat(impulse(0)).isEqualTo(1);
        assertThat(impulse(1)).isZero();
        assertThat(impulse(2)).isZero();
    }

    /**
     * When an island is solved again in other substeps, the body is delayed from the same place.
     */
    @Test
    void bodyIsDelayedAnew() {
        joiners.delayToSubsteps(0.2);
        assertThat(bodies.pileTime[2]).isCloseTo(0.2, within(ROUND_OFF));
        joiners.restoreTimes();
        assertThat(bodies.pileTime[2]).isEqualTo(LATE);
        assertThat(bodies.pileTime[1]).isZero();
        lay();
        bodyGoesOnItsParabolaFromTheSubstepInWhichItJoins();
    }

    /**
     * Three substeps straight on, then 0.07 s with its acceleration lead to place and velocity at
     * its joining.
     */
    @Test
    void bodyGoesOnItsParabolaFromTheSubstepInWhichItJoins() {
        joiners.delayToSubsteps(H);
        assertThat(bodies.pileTime[2]).isCloseTo(0.3, within(ROUND_OFF));
        double[] acceleration = {4, -10, 6};
        double[] joining = {2, -3, 5};
        double since = LATE - 0.3;
        for (int i = 0; i < 3; i++) {
            double v = of(2, Motions.VX + i);
            assertThat(v + since * acceleration[i]).isCloseTo(joining[i], within(ROUND_OFF));
            double place = of(2, Motions.DX + i) + LATE * v + since * since / 2 * acceleration[i];
            assertThat(place).isCloseTo(0, within(ROUND_OFF));
            assertThat(of(1, Motions.DX + i)).isZero();
            assertThat(of(3, Motions.DX + i)).isZero();
            assertThat(of(3, Motions.VX + i)).isEqualTo(joining[i]);
        }
        assertRowsJoinIn(3);
    }

    /** Bodies present from the start are left alone. */
    @Test
    void withoutLateJoinersNothingChanges() {
        bodies.pileTime[2] = 0;
        double[] before = motions.data.clone();
        joiners.delay(0, H);
        joiners.delayToSubsteps(H);
        assertThat(motions.data).isEqualTo(before);
        assertThat(contacts.firstSubstep[1]).isEqualTo(PackedContacts.ALWAYS);
        assertThat(impulse(1)).isEqualTo(1);
    }

    /** If both bodies of a contact are late, both are present in the later substep. */
    @Test
    void laterOfTwoDecides() {
        bodies.pileTime[1] = 0.15;
        joiners.delay(0, H);
        assertThat(contacts.firstSubstep[0]).isEqualTo(1);
        assertThat(contacts.firstSubstep[1]).isEqualTo(3);
    }

    @Test
    void drivenBodyNeverJoinsLate() {
        bodies.pileTime[3] = 0.2;
        bodies.pileTime[2] = 0;
        joiners.delayToSubsteps(H);
        assertThat(of(3, Motions.DX)).isZero();
        assertThat(contacts.firstSubstep[2]).isEqualTo(PackedContacts.ALWAYS);
    }

    /** Without rotation there are no angular accelerations to read. */
    @Test
    void bodiesThatDoNotTurnJoinToo() {
        Motions flat = new Motions(false);
        flat.count = 3;
        flat.slots[2] = 2;
        flat.data = Arrays.copyOf(motions.data, 4 * Motions.STRIDE);
        bodies.angularAcceleration = null;
        new LateJoiners(bodies, flat, contacts).delayToSubsteps(H);
        double since = LATE - 0.3;
        double v = flat.data[2 * Motions.STRIDE + Motions.VX];
        assertThat(v).isCloseTo(2 - since * 4, within(ROUND_OFF));
        assertThat(flat.data[2 * Motions.STRIDE + Motions.SPIN]).isEqualTo(5);
        assertThat(flat.data[2 * Motions.STRIDE + Motions.TURN]).isZero();
    }

    @Test
    void manyMayJoin() {
        lay(30);
        joiners.delay(0, H);
        assertThat(of(18, Motions.DX)).isCloseTo(-2 * LATE, within(ROUND_OFF));
        lay(30);
        new LateJoiners(bodies, motions, contacts).delayToSubsteps(H);
        assertThat(of(18, Motions.DX)).isNotZero();
    }
}
