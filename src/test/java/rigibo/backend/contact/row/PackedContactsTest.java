package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.impact.Impact;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.KeptOverlap;

/** Questions about all contacts of an island at once, and the overlap to be removed. */
class PackedContactsTest {

    private static final double ROUND_OFF = 1e-14;

    private final PackedIsland island = new PackedIsland();
    private final PackedContacts contacts = island.contacts;

    private void lay(int count) {
        island.begin(count);
        for (int entry = 1; entry <= count; entry++) {
            island.body(entry, 1, 0);
            island.onGround(entry, 0.5, 0.5);
        }
    }

    /** Up to 64 contacts of 3 rows each are eliminated; of more contacts only four a body count. */
    @Test
    void crowdsAreWhatEliminationDoesNotTake() {
        lay(64);
        assertThat(contacts.areCrowd()).isFalse();
        island.onGround(64, 0.5, 0.5);
        assertThat(contacts.areCrowd()).isTrue();
        lay(16);
        for (int i = 0; i < 200; i++) {
            island.onGround(1, 0.5, 0.5);
        }
        assertThat(contacts.areCrowd()).isFalse();
        Islands islands = new Islands();
        islands.bodyStart[1] = 20;
        islands.pairStart[1] = 64;
        islands.bodyStart[2] = 40;
        islands.pairStart[2] = 64 + 65;
        assertThat(PackedContacts.areCrowd(islands, 0)).isFalse();
        assertThat(PackedContacts.areCrowd(islands, 1)).isTrue();
    }

    @Test
    void whatStandsOnNothingFloats() {
        lay(2);
        assertThat(contacts.areFloating()).isFalse();
        contacts.groundStart = 2;
        assertThat(contacts.areFloating()).isTrue();
    }

    /** Each body stands on two: of 8 contacts of two bodies 4 carry, of 3 all. */
    @Test
    void aShareOfContactsIsLoaded() {
        lay(2);
        for (int i = 0; i < 6; i++) {
            island.onGround(1, 0.5, 0.5);
        }
        assertThat(contacts.shareLoaded()).isEqualTo(0.5);
        lay(3);
        assertThat(contacts.shareLoaded()).isEqualTo(1);
    }

    @Test
    void theGreatestIsTold() {
        lay(3);
        for (int row = 0; row < 3; row++) {
            island.set(row, PackedContacts.WIDTH, row == 1 ? 7 : 2);
            island.set(row, PackedContacts.ELASTICITY, row == 2 ? 0.9 : 0.1);
            island.set(row, PackedContacts.K00, row == 0 ? 2 : 1);
            island.set(row, PackedContacts.IMPULSE0, 3);
            island.set(row, PackedContacts.IMPULSE1, row);
        }
        assertThat(contacts.widest()).isEqualTo(7);
        assertThat(contacts.highestElasticity()).isEqualTo(0.9);
        assertThat(contacts.strongestAnswer()).isEqualTo(6);
    }

    @Test
    void pointsCarryInThisKickOrTheLast() {
        lay(1);
        assertThat(contacts.carries(0, 0)).isFalse();
        island.set(0, PackedContacts.IMPULSE0, 1);
        assertThat(contacts.carries(0, 0)).isTrue();
        assertThat(contacts.carries(0, 1)).isFalse();
        island.set(0, PackedContacts.BEFORE1, 1);
        assertThat(contacts.carries(0, 1)).isTrue();
    }

    /** All four impulses of a contact are scaled, added and removed together. */
    @Test
    void impulsesGoTogether() {
        lay(3);
        int[] all = {
            PackedContacts.IMPULSE0,
            PackedContacts.IMPULSE1,
            PackedContacts.IMPULSE_T,
            PackedContacts.IMPULSE_R
        };
        for (int row = 0; row < 3; row++) {
            for (int column : all) {
                island.set(row, column, row + column);
            }
        }
        contacts.addUpImpulses(3);
        double sum = 2 + 2 + PackedContacts.IMPULSE0 + PackedContacts.IMPULSE1;
        assertThat(island.of(2, PackedContacts.TOTAL)).isEqualTo(3 * sum);
        contacts.addUpImpulses(2, 2);
        assertThat(island.of(2, PackedContacts.TOTAL)).isEqualTo(5 * sum);
        contacts.scaleImpulses(1, 0.5);
        for (int column : all) {
            assertThat(island.of(1, column)).isEqualTo(0.5 * (1 + column));
            assertThat(island.of(2, column)).isEqualTo(2 + column);
        }
        contacts.joinsIn(2, 4);
        assertThat(contacts.lastJoining).isEqualTo(4);
        assertThat(contacts.firstSubstep[2]).isEqualTo(4);
        contacts.joinsIn(1, 3);
        assertThat(contacts.lastJoining).isEqualTo(4);
        contacts.unload();
        for (int row = 0; row < 3; row++) {
            for (int column : all) {
                assertThat(island.of(row, column)).isZero();
            }
        }
        contacts.clear(1);
        assertThat(contacts.count).isZero();
        assertThat(contacts.lastJoining).isEqualTo(PackedContacts.ALWAYS);
    }

    /** With the arms r of a point, r × n and r × t are its levers. */
    @Test
    void pointsHaveTheArmsOfTheirLevers() {
        lay(1);
        double[] values = {0.6, 0.8, 0.1, 0.2, 0.3, 0.4};
        System.arraycopy(values, 0, contacts.data, 0, values.length);
        island.set(0, PackedContacts.LEVER_TA, 0.5);
        island.set(0, PackedContacts.LEVER_TB, 0.7);
        Impact impact = new Impact();
        contacts.addPoint(0, 0, impact);
        contacts.addPoint(0, 1, impact);
        assertThat(impact.points).isEqualTo(2);
        for (int point = 0; point < 2; point++) {
            double[][] arms = {
                {impact.armAX[point], impact.armAY[point]},
                {impact.armBX[point], impact.armBY[point]}
            };
            for (int side = 0; side < 2; side++) {
                double x = arms[side][0];
                double y = arms[side][1];
                double across = island.of(0, PackedContacts.LEVER_A0 + 2 * point + side);
                double along = island.of(0, PackedContacts.LEVER_TA + side);
                assertThat(x * 0.8 - y * 0.6).isCloseTo(across, within(ROUND_OFF));
                // The tangent is (−0.8, 0.6).
                assertThat(x * 0.6 + y * 0.8).isCloseTo(along, within(ROUND_OFF));
            }
        }
    }

    /**
     * The share r·h/(1 + r·h) of the overlap that is not kept, at a greatest rate in widths a
     * second.
     */
    @Test
    void overlapOpensByItsRate() {
        lay(1);
        island.set(0, PackedContacts.WIDTH, 2);
        island.set(0, PackedContacts.RECOVERY, 30);
        double over = 0.01 - 2 * 1e-3;
        assertThat(Recovery.opens(contacts, 0, -0.01, 1e-3, 0.1, 9))
                .isCloseTo(over * 3 / 4, within(ROUND_OFF));
        assertThat(Recovery.opens(contacts, 0, -0.01, 1e-3, 0.1, 0.02))
                .isCloseTo(0.004, within(ROUND_OFF));
        assertThat(Recovery.opens(contacts, 0, -0.0019, 1e-3, 0.1, 9)).isZero();
        // Removed from that overlap in a step.
        double all = Recovery.overlapOf(1e-6, 0.1);
        assertThat(all * 2.5 / 3.5).isCloseTo(1e-6, within(1e-18));
    }

    /** Ten times the tolerance of impacts in a crowd, within bounds; twice that in a calm one. */
    @Test
    void crowdsKeepMore() {
        Accuracy fine = Accuracy.GAME.withImpactTolerance(2e-5);
        assertThat(KeptOverlap.of(false, fine)).isEqualTo(1e-5);
        assertThat(KeptOverlap.ifCalm(false, fine)).isEqualTo(1e-5);
        assertThat(KeptOverlap.of(true, fine)).isCloseTo(2e-4, within(ROUND_OFF));
        assertThat(KeptOverlap.ifCalm(true, fine)).isCloseTo(4e-4, within(ROUND_OFF));
        assertThat(KeptOverlap.of(true, Accuracy.GAME.withImpactTolerance(1e-3))).isEqualTo(1e-3);
        assertThat(KeptOverlap.of(true, Accuracy.GAME.withImpactTolerance(1e-9))).isEqualTo(1e-5);
    }

    /**
     * The kick's length times the pull, and the impulses of the body's contacts; friction counts in
     * either direction.
     */
    @Test
    void ownLoadsAreThoseOfTheBodyAlone() {
        Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
        OwnLoads own = new OwnLoads(bodies, island.motions, contacts);
        island.begin(40);
        for (int entry = 1; entry <= 40; entry++) {
            island.body(entry, 0.5, 0);
            int row = island.contact(entry - 1, entry, 0.5, 0.5);
            island.set(row, PackedContacts.IMPULSE0, entry);
            island.set(row, PackedContacts.IMPULSE1, 2 * entry);
            island.set(row, PackedContacts.IMPULSE_T, -3 * entry);
        }
        bodies.accelerationX[0] = -2;
        bodies.accelerationY[0] = 1;
        own.measure(0.25);
        assertThat(own.pull(7)).isEqualTo(2);
        assertThat(own.of(7)).isCloseTo(0.5 + 0.5 * 6 * (7 + 8), within(ROUND_OFF));
        assertThat(own.of(40)).isCloseTo(0.5 + 0.5 * 6 * 40, within(ROUND_OFF));
        bodies.accelerationY[0] = -3;
        assertThat(own.pull(7)).isEqualTo(3);
    }
}
