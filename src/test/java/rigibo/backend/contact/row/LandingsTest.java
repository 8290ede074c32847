package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.storage.Bodies;

/**
 * A body of two metres falls onto the ground with g. A landing is predicted to leave half the gap
 * that counts as landed, 50 µm here: then v·t + g·t²/2 is the rest of the gap, where g is an upper
 * bound until loads are known.
 */
class LandingsTest {

    private static final double G = 10;
    private static final double H = 0.1;
    private static final double NEAR = 1e-4;
    private static final double ROUND_OFF = 1e-12;
    private static final double FOREVER = Double.POSITIVE_INFINITY;

    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final Kick kick = new Kick(bodies, motions, null, null, null);
    private final Landings landings =
            new Landings(motions, contacts, kick, Accuracy.GAME.withImpactTolerance(5e-4));
    private int row;

    @BeforeEach
    void lay() {
        island.begin(2);
        island.body(1, 1, 1);
        island.body(2, 1, 1);
        motions.slots[1] = 1;
        motions.slots[2] = 2;
        bodies.accelerationY[1] = -G;
        motions.data[Motions.STRIDE + Motions.VX] = 1;
        row = island.onGround(2, 0.5, 0.5);
        gap(0, 1e9);
        gap(1, 1e9);
        row = island.onGround(1, 0.5, 0.5);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH] = 2;
        contacts.lastJoining = PackedContacts.ALWAYS;
        gap(0, 1e9);
        gap(1, 1e9);
        landings.begin();
        landings.beginSubstep();
    }

    private void gap(int point, double gap) {
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0 + point] = gap;
    }

    private double gap(int point) {
        return motions.gap(contacts, row, point);
    }

    private void fall(double speed) {
        motions.data[Motions.STRIDE + Motions.VY] = -speed;
    }

    private double next(double most) {
        return landings.untilNext(H, most);
    }

    /** Loads may double the acceleration: v·t + g·t² is the way. */
    @ParameterizedTest
    @CsvSource({"0, 2, 0.03", "1, 2, 0.03", "0, 0, 0.05", "1, -0.1, 0.06"})
    void firstPartEndsWhenTheBodyMayLand(int point, double speed, double time) {
        fall(speed);
        gap(point, NEAR / 2 + speed * time + G * time * time);
        assertThat(next(FOREVER)).isCloseTo(time, within(ROUND_OFF));
    }

    /**
     * The earlier of two landings, but no later than the caller's limit or the end of the substep.
     */
    @Test
    void earliestLandingEndsThePart() {
        fall(2);
        gap(0, NEAR / 2 + 2 * 0.04 + G * 0.04 * 0.04);
        gap(1, NEAR / 2 + 2 * 0.03 + G * 0.03 * 0.03);
        assertThat(next(FOREVER)).isCloseTo(0.03, within(ROUND_OFF));
        assertThat(next(0.02)).isEqualTo(0.02);
        gap(0, 1e3);
        gap(1, 1e3);
        assertThat(next(FOREVER)).isEqualTo(H);
        // A point that touches already does not land.
        gap(0, NEAR);
        assertThat(next(FOREVER)).isEqualTo(H);
    }

    /**
     * At a constant speed. A hundredth of the change by g in a substep, 0.01 m/s, does not count.
     */
    @ParameterizedTest
    @CsvSource({"0.0101, true", "0.0099, false"})
    void softLandingsDoNotCount(double speed, boolean counts) {
        next(0.02);
        // Its load balances nine tenths of g: a tenth is the allowance.
        fall(speed + 0.1 * G * 0.02);
        next(0.02);
        fall(speed);
        gap(0, 1.2 * NEAR);
        double time = 0.7 * NEAR / speed;
        assertThat(next(FOREVER)).isCloseTo(counts ? time : H, within(ROUND_OFF));
    }

    /** Without a strike the next part continues the last one, with a tenth of g more. */
    @Test
    void laterPartsGoOnAsTheLastOne() {
        motions.data[2 * Motions.STRIDE + Motions.VY] = 0.25;
        contacts.bodyA[row] = 2 * Motions.STRIDE;
        fall(0);
        assertThat(next(0.02)).isEqualTo(0.02);
        fall(0.1);
        assertThat(next(0.02)).isEqualTo(0.02);
        // Both kicks last half a part, 0.02 s; both bodies have gained speed, and also spin.
        fall(0.1 + 0.06);
        motions.data[2 * Motions.STRIDE + Motions.VY] = 0.25 + 0.05;
        motions.data[Motions.STRIDE + Motions.SPIN] = -0.04;
        double gain = 3 + 2.5 + 0.04 / 0.02 * 0.5 + 0.1 * G;
        double closing = 0.16 + 0.30 + 0.04 * 0.5 + gain * 0.01;
        double time = 0.03;
        gap(1, NEAR / 2 + closing * time + gain * time * time / 2);
        assertThat(next(FOREVER)).isCloseTo(time, within(ROUND_OFF));
    }

    /** A gain of more than twice g is a strike, after which loads are unknown again. */
    @ParameterizedTest
    @CsvSource({"0.39, false", "0.41, true"})
    void struckBodyMayFallTwiceAsFast(double gained, boolean isStruck) {
        fall(0);
        next(0.02);
        next(0.02);
        motions.data[Motions.STRIDE + Motions.VX] = 1 - gained / 2;
        fall(gained / 2);
        double gain = isStruck ? 2 * G : gained / 2 / 0.02 + 0.1 * G;
        double closing = gained / 2 + gain * 0.01;
        double time = 0.03;
        gap(0, NEAR / 2 + closing * time + gain * time * time / 2);
        assertThat(next(FOREVER)).isCloseTo(time, within(ROUND_OFF));
    }

    /** The part after the first counts as one after a landing. */
    @Test
    void firstGainIsNotKnownEither() {
        fall(0);
        next(0.02);
        fall(0.1);
        double time = 0.03;
        double closing = 0.1 + 2 * G * 0.01;
        gap(0, NEAR / 2 + closing * time + G * time * time);
        assertThat(next(FOREVER)).isCloseTo(time, within(ROUND_OFF));
    }

    /** The 64th part takes the rest of the substep. */
    @Test
    void partsOfASubstepAreLimited() {
        fall(1);
        for (int i = 1; i < 64; i++) {
            assertThat(next(0.01)).isEqualTo(0.01);
        }
        assertThat(next(0.01)).isEqualTo(H);
        landings.beginSubstep();
        assertThat(next(0.01)).isEqualTo(0.01);
    }

    private static Accuracy split() {
        return Accuracy.GAME.withImpacts(ImpactMode.SPLIT);
    }

    /** Only for few bodies that are all present, with impacts in time order. */
    @Test
    void crowdsAndLateJoinersAreNotCut() {
        assertThat(landings.areLookedFor()).isTrue();
        Landings none = new Landings(motions, contacts, kick, split());
        none.begin();
        assertThat(none.areLookedFor()).isFalse();
        assertThat(none.untilNext(0.3, 0.1)).isEqualTo(0.3);
        contacts.lastJoining = 0;
        landings.begin();
        assertThat(landings.areLookedFor()).isTrue();
        contacts.lastJoining = 1;
        landings.begin();
        assertThat(landings.areLookedFor()).isFalse();
        contacts.lastJoining = 0;
        motions.count = Motions.FEW + 2;
        landings.begin();
        assertThat(landings.areLookedFor()).isFalse();
    }

    /**
     * A landed point is put a width away until it is closed, so that it carries nothing of the kick
     * that ends.
     */
    @Test
    void landedPointIsAsideUntilItIsClosed() {
        gap(0, 0.02);
        gap(1, 0.01 + 2e-4);
        fall(1);
        assertThat(landings.haveLanded(H)).isFalse();
        next(0.01);
        motions.data[Motions.STRIDE + Motions.DY] = -0.01015;
        assertThat(landings.haveLanded(H)).isTrue();
        assertThat(gap(1)).isCloseTo(2 + 5e-5, within(ROUND_OFF));
        assertThat(gap(0)).isCloseTo(0.00985, within(ROUND_OFF));
        landings.close();
        assertThat(gap(1)).isCloseTo(0, within(1e-15));
        assertThat(gap(0)).isCloseTo(0.00985, within(ROUND_OFF));
        // The next part begins with the present velocities, and a point that touched is no landing.
        assertThat(landings.haveLanded(H)).isFalse();
        next(0.01);
        assertThat(landings.haveLanded(H)).isFalse();
    }

    @ParameterizedTest
    @CsvSource({
        "0.00011, 1, false",
        "0.00009, 1, true",
        "0.00009, 0.0099, false",
        "0.00009, 0.0101, true"
    })
    void pointsLandWithinTheToleranceAndWithSomeSpeed(
            double left, double speed, boolean hasLanded) {
        gap(0, 0.01);
        fall(speed);
        next(0.01);
        motions.data[Motions.STRIDE + Motions.DY] = left - 0.01;
        assertThat(landings.haveLanded(H)).isEqualTo(hasLanded);
    }

    @Test
    void secondPointOfOneDoesNotLand() {
        contacts.points[row] = 1;
        gap(1, 0.01);
        fall(1);
        assertThat(next(FOREVER)).isEqualTo(H);
        motions.data[Motions.STRIDE + Motions.DY] = -0.01;
        assertThat(landings.haveLanded(H)).isFalse();
    }

    /** A gap within the tolerance that carries, and that turning did not open. */
    @ParameterizedTest
    @CsvSource({
        "0.00009, 1, 0, 0",
        "0.00009, 0, 0, 0.00009",
        "0.00011, 1, 0, 0.00011",
        "-0.0001, 1, 0, -0.0001",
        "0.00009, 1, 0.13, 0",
        "0.00009, 1, 0.15, 0.00009"
    })
    void gapsOfPointsThatCarryStayClosed(double open, double load, double spin, double left) {
        gap(0, open);
        // 0.13 rad/s for a tenth of a second: a sagitta of 0.013²/2 = 85 µm.
        motions.data[Motions.STRIDE + Motions.SPIN] = spin;
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = load;
        landings.keepClosed(H);
        assertThat(gap(0)).isCloseTo(left, within(1e-16));
        assertThat(gap(1)).isEqualTo(1e9);
    }

    @Test
    void turningOfBothOutlinesCounts() {
        contacts.bodyA[row] = 2 * Motions.STRIDE;
        gap(1, 9e-5);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE1] = 1;
        motions.data[Motions.STRIDE + Motions.SPIN] = 0.11;
        motions.data[2 * Motions.STRIDE + Motions.SPIN] = 0.11;
        landings.keepClosed(H);
        assertThat(gap(1)).isEqualTo(9e-5);
        motions.reach[2] = 0;
        landings.keepClosed(H);
        assertThat(gap(1)).isCloseTo(0, within(1e-16));
    }

    @Test
    void whatADrivenBodySqueezesMayStayOpen() {
        gap(0, 9e-5);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.IMPULSE0] = 1;
        motions.isAnyDriven = true;
        landings.keepClosed(H);
        assertThat(gap(0)).isEqualTo(9e-5);
    }

    /** There are more contacts than the first capacity. */
    @Test
    void everyPointMayLand() {
        for (int i = 0; i < 20; i++) {
            row = island.onGround(1, 0.5, 0.5);
            contacts.data[row * PackedContacts.STRIDE + PackedContacts.WIDTH] = 2;
            gap(0, 1e9);
            gap(1, 1e9);
        }
        fall(2);
        gap(1, NEAR / 2 + 2 * 0.03 + G * 0.03 * 0.03);
        assertThat(next(FOREVER)).isCloseTo(0.03, within(ROUND_OFF));
    }
}
