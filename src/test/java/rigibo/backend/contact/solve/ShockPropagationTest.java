package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/** Impulses handed down a pile, compared with the momentum to be stopped. */
class ShockPropagationTest {

    private static final double SPEED = 3;

    /** Inverse inertia of a square of 1 m, times its mass, 1/m². */
    private static final double INVERSE_INERTIA = 6;

    /**
     * Share of a speed that eight rounds stop. At half a metre from the centre of a square the
     * response is 1 + 6/4 of the inverse mass, so each round stops 1/2.5 of it.
     */
    private static final double STOPPED = 1 - Math.pow(1 - 1 / 2.5, 8);

    private static final double ROUND_OFF = 1e-12;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final ShockPropagation shock = new ShockPropagation(bodies, motions, contacts);
    private final double[] spare = new double[64];
    private final double[] changed = new double[64];

    @BeforeEach
    void pullDown() {
        Arrays.fill(bodies.accelerationY, -9.81);
    }

    private void handDown() {
        shock.handDown(0, spare, changed, 1e-9);
    }

    /** Bodies on each other, with points half a metre to either side. */
    private void stack(double... inverseMasses) {
        island.begin(inverseMasses.length);
        for (int entry = 1; entry <= inverseMasses.length; entry++) {
            double inverseMass = inverseMasses[entry - 1];
            island.body(entry, inverseMass, INVERSE_INERTIA * inverseMass);
            motions.slots[entry] = entry;
        }
        for (int entry = 1; entry <= inverseMasses.length; entry++) {
            island.contact(entry - 1, entry, 0.5, 0.5);
        }
    }

    private double velocityY(int entry) {
        return motions.data[entry * Motions.STRIDE + Motions.VY];
    }

    private void fall(int entry) {
        motions.data[entry * Motions.STRIDE + Motions.VY] = -SPEED;
    }

    private double impulse(int row) {
        int at = row * PackedContacts.STRIDE;
        return contacts.data[at + PackedContacts.IMPULSE0]
                + contacts.data[at + PackedContacts.IMPULSE1];
    }

    /** Each contact of a stack carries the momentum of the body that landed on its top. */
    @Test
    void aStackHandsAnImpactToTheGround() {
        double[] inverseMasses = {1, 0.1, 4, 1, 1, 2, 0.5};
        stack(inverseMasses);
        fall(7);
        handDown();
        double momentum = SPEED / 0.5;
        for (int entry = 7; entry >= 1; entry--) {
            double left = (1 - STOPPED) * momentum * inverseMasses[entry - 1];
            momentum *= STOPPED;
            assertThat(impulse(entry - 1)).isCloseTo(momentum, within(ROUND_OFF));
            assertThat(velocityY(entry)).as("body " + entry).isCloseTo(-left, within(ROUND_OFF));
        }
    }

    /**
     * A body may close the gaps below it, including those of others, and bodies at rest do not
     * move.
     */
    @Test
    void gapsLetWhatIsAboveSink() {
        stack(1, 1, 1);
        fall(2);
        fall(3);
        Arrays.fill(spare, 2, 4, 0.4);
        Arrays.fill(spare, 4, 6, 0.3);
        handDown();
        double onSecond = STOPPED * (SPEED - 0.4 - 0.3);
        double onFirst = STOPPED * (SPEED + onSecond - 0.4);
        assertThat(impulse(2)).isCloseTo(onSecond, within(ROUND_OFF));
        assertThat(impulse(1)).isCloseTo(onFirst, within(ROUND_OFF));
        assertThat(impulse(0)).isCloseTo(STOPPED * onFirst, within(ROUND_OFF));
        assertThat(velocityY(3)).isCloseTo(onSecond - SPEED, within(ROUND_OFF));
        assertThat(velocityY(2)).isCloseTo(onFirst - onSecond - SPEED, within(ROUND_OFF));
    }

    /** A body that falls no faster than it may is left alone. */
    @Test
    void whatDoesNotCloseIsNotTouched() {
        stack(1, 1);
        contacts.data[PackedContacts.IMPULSE0] = 7;
        motions.data[2 * Motions.STRIDE + Motions.VY] = 1;
        handDown();
        assertThat(impulse(0)).isEqualTo(7);
        assertThat(impulse(1)).isZero();
        assertThat(velocityY(2)).isEqualTo(1);
    }

    /**
     * Two bodies below share a load equally; a load beside the middle goes to the nearer points;
     * momentum is kept.
     */
    @Test
    void twoSupportsShareALoad() {
        island.begin(3);
        for (int entry = 1; entry <= 3; entry++) {
            island.body(entry, 1, INVERSE_INERTIA);
            motions.slots[entry] = entry;
        }
        int left = half(1, -0.5, 0, 0, 0.5);
        int right = half(2, 0, 0.5, -0.5, 0);
        int groundLeft = island.onGround(1, 0.5, 0.5);
        int groundRight = island.onGround(2, 0.5, 0.5);
        fall(3);
        handDown();
        assertThat(impulse(left)).isCloseTo(impulse(right), within(ROUND_OFF));
        double onBoth = impulse(left) + impulse(right);
        assertThat(onBoth).isCloseTo(SPEED + velocityY(3), within(ROUND_OFF));
        assertThat(velocityY(3)).isBetween(-0.1 * SPEED, 0.0);
        assertThat(impulse(groundLeft)).isCloseTo(impulse(groundRight), within(ROUND_OFF));
        assertThat(impulse(groundLeft))
                .isCloseTo(impulse(left) + velocityY(1), within(ROUND_OFF))
                .isGreaterThan(0.9 * impulse(left));
        int at = groundLeft * PackedContacts.STRIDE;
        assertThat(contacts.data[at + PackedContacts.IMPULSE1])
                .isGreaterThan(contacts.data[at + PackedContacts.IMPULSE0]);
    }

    /** Body 3 on another one, over one half of its lower side. */
    private int half(int lower, double left3, double right3, double left, double right) {
        int row = island.contact(lower, 3, 0.5, 0.5);
        int at = row * PackedContacts.STRIDE;
        contacts.data[at + PackedContacts.LEVER_B0] = left3;
        contacts.data[at + PackedContacts.LEVER_B1] = right3;
        contacts.data[at + PackedContacts.LEVER_A0] = left;
        contacts.data[at + PackedContacts.LEVER_A1] = right;
        return row;
    }

    /** A body that stands on one point gives way, so nothing is stopped on it. */
    @Test
    void nothingIsStoppedOnWhatStandsOnAPoint() {
        stack(1, 1, 1);
        int at = PackedContacts.STRIDE;
        contacts.points[1] = 1;
        contacts.data[at + PackedContacts.LEVER_A0] = 0;
        contacts.data[at + PackedContacts.LEVER_B0] = 0;
        fall(3);
        handDown();
        assertThat(impulse(2)).isZero();
        assertThat(velocityY(3)).isEqualTo(-SPEED);
    }

    /** A disc between two others that lie on the ground is held by both normals together. */
    @Test
    void aDiscBetweenTwoIsHeld() {
        island.begin(3);
        for (int entry = 1; entry <= 3; entry++) {
            island.body(entry, 1, INVERSE_INERTIA);
            motions.slots[entry] = entry;
        }
        island.onGround(1, 0.5, 0.5);
        island.onGround(2, 0.5, 0.5);
        int left = disc(1, Math.PI / 3);
        int right = disc(2, 2 * Math.PI / 3);
        fall(3);
        handDown();
        double carried = Math.sin(Math.PI / 3) * (impulse(left) + impulse(right));
        assertThat(impulse(left)).isCloseTo(impulse(right), within(ROUND_OFF));
        assertThat(carried).isCloseTo(SPEED + velocityY(3), within(ROUND_OFF));
        assertThat(velocityY(3)).isBetween(-0.1 * SPEED, 0.0);
    }

    /** Disc 3 on another one, the normal at an angle. */
    private int disc(int lower, double angle) {
        int row = island.contact(lower, 3, 0, 0);
        int at = row * PackedContacts.STRIDE;
        contacts.points[row] = 1;
        contacts.data[at + PackedContacts.NX] = Math.cos(angle);
        contacts.data[at + PackedContacts.NY] = Math.sin(angle);
        return row;
    }

    /** Without a pull no body lies on another; and a body that joins later is not present yet. */
    @Test
    void nothingIsHandedDownWithoutAPullOrBeforeItJoins() {
        stack(1, 1);
        fall(2);
        Arrays.fill(bodies.accelerationY, 0);
        handDown();
        assertThat(velocityY(2)).isEqualTo(-SPEED);
        pullDown();
        contacts.firstSubstep[1] = 1;
        handDown();
        assertThat(velocityY(2)).isEqualTo(-SPEED);
    }

    /** Bodies that lie on each other in a ring have no order, and none of them is held. */
    @Test
    void aRingIsLeftOut() {
        stack(1, 1);
        int back = island.contact(2, 1, 0.5, 0.5);
        fall(2);
        handDown();
        assertThat(impulse(back)).isZero();
        assertThat(impulse(1)).isZero();
    }

    /** Each change of speed, including that of the outline, counts for the next sweep. */
    @Test
    void changesAreNoted() {
        stack(1, 1);
        fall(2);
        handDown();
        // Change per impulse: by the mass, and by the radius of 1 m times the turning, at a lever
        // of half a metre.
        double perImpulse = 1 + INVERSE_INERTIA * 0.5;
        double onSecond = perImpulse * impulse(1);
        assertThat(changed[2]).isCloseTo(onSecond, within(ROUND_OFF));
        assertThat(changed[1]).isCloseTo(onSecond + perImpulse * impulse(0), within(ROUND_OFF));
        assertThat(changed[0]).isZero();
    }
}
