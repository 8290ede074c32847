package rigibo.backend.contact.hold;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;

import java.util.SplittableRandom;

/**
 * Bodies that a kick of a tenth of a second under 10 m/s² left with 1 m/s downwards, compared with
 * statics.
 */
class LoadsFromAboveTest {

    private static final double KICK = 0.1;
    private static final double PULL = 10;

    /** Rounds end at 10⁻¹⁰ of the load of a body, and loads add up from storey to storey. */
    private static final double HELD = 1e-9;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final LoadsFromAbove loads =
            new LoadsFromAbove(bodies, motions, contacts, Accuracy.GAME);

    private void begin(int count) {
        island.begin(count);
    }

    /** A body at a height along the pull, m. */
    private void body(int entry, double mass, double inertia, double height) {
        island.body(entry, 1 / mass, inertia > 0 ? 1 / inertia : 0);
        motions.slots[entry] = entry;
        bodies.y[entry] = height;
        bodies.boundingRadius[entry] = 1;
        bodies.accelerationY[entry] = -PULL;
        motions.data[entry * Motions.STRIDE + Motions.VY] = -PULL * KICK;
    }

    private double load(int row) {
        return island.of(row, PackedContacts.IMPULSE0) + island.of(row, PackedContacts.IMPULSE1);
    }

    private void assertAllStand(int count) {
        for (int entry = 1; entry <= count; entry++) {
            int at = entry * Motions.STRIDE;
            assertThat(motions.data[at + Motions.VX]).isCloseTo(0, within(HELD));
            assertThat(motions.data[at + Motions.VY]).isCloseTo(0, within(HELD));
            assertThat(motions.data[at + Motions.SPIN]).isCloseTo(0, within(HELD));
        }
    }

    /** Each contact carries all bodies above it, whatever their order. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void columnCarriesWhatLiesOnIt(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int count = 12;
        begin(count);
        double[] mass = random.doubles(count, 0.5, 20).toArray();
        int[] entries = random.ints(1, count + 1).distinct().limit(count).toArray();
        for (int storey = 0; storey < count; storey++) {
            body(entries[storey], mass[storey], 0.2 * mass[storey], storey - 5);
        }
        for (int storey = count - 1; storey >= 0; storey--) {
            island.contact(storey == 0 ? 0 : entries[storey - 1], entries[storey], 0.4, 0.4);
        }
        assertThat(loads.handDown(KICK)).isTrue();
        double above = 0;
        for (int row = 0; row < count; row++) {
            above += mass[count - 1 - row];
            double truth = above * PULL * KICK;
            assertThat(load(row)).isCloseTo(truth, within(HELD * truth));
        }
        assertAllStand(count);
    }

    /** A beam on two supports: N₀ = W·b/(a + b), N₁ = W·a/(a + b), with either body as A. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.5, false", "0.1, 0.9, false", "0.3, 0.5, true"})
    void cornersShareByTheirLevers(double left, double right, boolean isA) {
        begin(1);
        body(1, 3, 2, 0);
        int row = isA ? island.contact(1, 0, left, right) : island.onGround(1, left, right);
        if (isA) {
            // From the body down to the ground: normal and levers are those of the other body.
            int at = row * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.NY] = -1;
            contacts.data[at + PackedContacts.LEVER_A0] = left;
            contacts.data[at + PackedContacts.LEVER_A1] = -right;
        }
        assertThat(loads.handDown(KICK)).isTrue();
        double weight = 3 * PULL * KICK;
        double first = weight * right / (left + right);
        assertThat(island.of(row, PackedContacts.IMPULSE0)).isCloseTo(first, within(HELD * weight));
        assertThat(load(row)).isCloseTo(weight, within(HELD * weight));
        assertAllStand(1);
    }

    /** A body whose centre is beyond both corners tips; its loads are not determined. */
    @Test
    void whatTipsIsNotHeld() {
        begin(1);
        body(1, 3, 2, 0);
        island.onGround(1, 0.5, -0.1);
        assertThat(loads.handDown(KICK)).isFalse();
    }

    /**
     * A corner 0.1 mm above the ground carries its share in a crowd, which keeps overlaps of 2 mm.
     * In an island of few contacts it does not, and the body tips.
     */
    @ParameterizedTest
    @CsvSource({"1, false", "300, true"})
    void cornersThatNearlyTouchCarryInACrowd(int count, boolean isHeld) {
        begin(count);
        bodies.reserve(count + 1);
        for (int entry = 1; entry <= count; entry++) {
            body(entry, 3, 2, 0);
            int row = island.onGround(entry, 0.5, 0.3);
            contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP1] = 1e-4;
        }
        assertThat(loads.handDown(KICK)).isEqualTo(isHeld);
        if (isHeld) {
            double weight = 3 * PULL * KICK;
            double near = weight * 0.5 / 0.8;
            assertThat(island.of(0, PackedContacts.IMPULSE1))
                    .isCloseTo(near, within(HELD * weight));
            assertAllStand(count);
        }
    }

    /** Puts the first body on a slope, rad, with two points at equal distances from its centre. */
    private int onSlope(double slope, double friction) {
        int row = island.onGround(1, 0.5, 0.5);
        int at = row * PackedContacts.STRIDE;
        contacts.data[at + PackedContacts.NX] = -Math.sin(slope);
        contacts.data[at + PackedContacts.NY] = Math.cos(slope);
        contacts.data[at + PackedContacts.FRICTION] = friction;
        return row;
    }

    /** On a slope of angle θ: W·cos θ by the normal, W·sin θ by friction, if tan θ ≤ μ. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.31, true", "0.3, 0.309, false", "-0.5, 0.55, true", "-0.5, 0.54, false"})
    void slopeHoldsByFriction(double slope, double friction, boolean isHeld) {
        begin(1);
        body(1, 2, 0, 0);
        int row = onSlope(slope, friction);
        assertThat(loads.handDown(KICK)).isEqualTo(isHeld);
        if (isHeld) {
            double weight = 2 * PULL * KICK;
            assertThat(load(row)).isCloseTo(weight * Math.cos(slope), within(HELD * weight));
            // The tangent is the normal turned to the left. On a slope that falls to the left it
            // points down, and friction points up.
            assertThat(island.of(row, PackedContacts.IMPULSE_T))
                    .isCloseTo(-weight * Math.sin(slope), within(HELD * weight));
            assertAllStand(1);
        }
    }

    /** Friction below the centre turns the body: the corner down the slope carries more. */
    @Test
    void frictionTurnsTheBody() {
        double slope = 0.2;
        double height = 0.3;
        begin(1);
        body(1, 2, 0.5, 0);
        int row = onSlope(slope, 1);
        // r × t for a point below the centre.
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.LEVER_TB] = -height;
        assertThat(loads.handDown(KICK)).isTrue();
        double weight = 2 * PULL * KICK;
        double rubs = weight * Math.sin(slope);
        double difference =
                island.of(row, PackedContacts.IMPULSE0) - island.of(row, PackedContacts.IMPULSE1);
        // Σ lever·j = 0: the slope falls to the left.
        assertThat(0.5 * difference).isCloseTo(height * rubs, within(HELD * weight));
        assertThat(load(row)).isCloseTo(weight * Math.cos(slope), within(HELD * weight));
    }

    /** Friction of the last step that is no longer needed is dropped, so that it pushes nothing. */
    @Test
    void carriedFrictionIsBoundedByTheLoad() {
        begin(1);
        body(1, 2, 0, 0);
        int row = island.onGround(1, 0.5, 0.5);
        int at = row * PackedContacts.STRIDE;
        contacts.data[at + PackedContacts.IMPULSE_T] = 0.5;
        motions.data[Motions.STRIDE + Motions.VX] = -0.25;
        assertThat(loads.handDown(KICK)).isTrue();
        assertThat(island.of(row, PackedContacts.IMPULSE_T)).isZero();
        assertAllStand(1);
    }

    /** A gap of more than 10⁻⁹ widths carries no load, unless it carried one before. */
    @Test
    void gapsCarryNothingAnew() {
        begin(1);
        body(1, 2, 0, 0);
        int row = island.onGround(1, 0.5, 0.5);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] = 0.9e-9;
        assertThat(loads.handDown(KICK)).isTrue();
        body(1, 2, 0, 0);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = 0;
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] = 1.1e-9;
        assertThat(loads.handDown(KICK)).isFalse();
        body(1, 2, 0, 0);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = 1e-3;
        assertThat(loads.handDown(KICK)).isTrue();
    }

    /** Excess of an earlier load is taken back, down to none. */
    @Test
    void carriedLoadsAreCorrected() {
        begin(2);
        body(1, 1, 0, 0);
        body(2, 1, 0, 1);
        int lower = island.onGround(1, 0.5, 0.5);
        int upper = island.contact(1, 2, 0.5, 0.5);
        double[] d = contacts.data;
        d[upper * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = 7;
        motions.data[2 * Motions.STRIDE + Motions.VY] += 7;
        motions.data[Motions.STRIDE + Motions.VY] -= 7;
        assertThat(loads.handDown(KICK)).isTrue();
        assertThat(load(upper)).isCloseTo(1, within(HELD));
        assertThat(load(lower)).isCloseTo(2, within(HELD));
    }

    /** The pull defines above and below, not the y axis: here it points to the right. */
    @Test
    void whatIsAboveIsSaidByThePull() {
        begin(3);
        for (int entry = 1; entry <= 3; entry++) {
            body(entry, 1, 0, 0);
            bodies.x[entry] = entry;
            bodies.accelerationX[entry] = PULL;
            bodies.accelerationY[entry] = 0;
            motions.data[entry * Motions.STRIDE + Motions.VX] = PULL * KICK;
            motions.data[entry * Motions.STRIDE + Motions.VY] = 0;
        }
        for (int entry = 1; entry <= 3; entry++) {
            int row = island.contact(entry, entry == 3 ? 0 : entry + 1, 0.5, 0.5);
            contacts.data[row * PackedContacts.STRIDE + PackedContacts.NX] = 1;
            contacts.data[row * PackedContacts.STRIDE + PackedContacts.NY] = 0;
        }
        assertThat(loads.handDown(KICK)).isTrue();
        for (int row = 0; row < 3; row++) {
            assertThat(load(row)).isCloseTo(row + 1, within(HELD));
        }
        assertAllStand(3);
    }

    /** A kick also moves driven bodies, which need no support. */
    @Test
    void whatNobodyCanMoveNeedsNoSupport() {
        begin(2);
        body(1, 1, 0, 1);
        body(2, 1, 0, 0);
        island.body(2, 0, 0);
        island.contact(2, 1, 0.5, 0.5);
        assertThat(loads.handDown(KICK)).isTrue();
        assertThat(load(0)).isCloseTo(1, within(HELD));
        assertThat(motions.data[2 * Motions.STRIDE + Motions.VY]).isEqualTo(-1);
    }

    @Test
    void whatLiesOnNothingIsNotHeld() {
        begin(2);
        body(1, 1, 0, 0);
        body(2, 1, 0, 1);
        island.onGround(1, 0.5, 0.5);
        assertThat(loads.handDown(KICK)).isFalse();
    }
}
