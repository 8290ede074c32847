package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.KeptOverlap;

import java.util.SplittableRandom;

/** Crushed bodies, two metres wide, that are moved apart in steps of a hundredth of a second. */
class JamTest {

    private static final double H = 0.01;
    private static final double WIDTH = 2;

    /** Twelve passes, each of which removes the share 25·h/(1 + 25·h) of the rest. */
    private static final double LEFT = Math.pow(1 / (1 + Recovery.RATE * H), 12);

    private static final double MOST = Recovery.MOST_PUSH * H * WIDTH;
    private static final double ROUND_OFF = 1e-12;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final OverlapSolver overlap =
            new OverlapSolver(bodies, motions, contacts, Accuracy.GAME);

    @BeforeEach
    void widen() {
        bodies.smallestWidth[0] = WIDTH;
        bodies.boundingRadius[0] = 1;
    }

    private void overlap(int row, double first, double second) {
        int at = row * PackedContacts.STRIDE;
        contacts.data[at + PackedContacts.WIDTH] = WIDTH;
        contacts.data[at + PackedContacts.RECOVERY] = Recovery.RATE;
        contacts.data[at + PackedContacts.GAP0] = -first;
        contacts.data[at + PackedContacts.GAP1] = -second;
    }

    /** Empties the island and adds a number of bodies of 1 kg that do not turn. */
    private void beginFree(int count) {
        island.begin(count);
        for (int entry = 1; entry <= count; entry++) {
            island.body(entry, 1, 0);
        }
    }

    private void part() {
        contacts.isAnyCrushed = true;
        overlap.prepare(true);
        assertThat(overlap.isJammed()).isTrue();
        overlap.partJammed(H, 0);
    }

    /** Share of the overlap that is not kept. */
    private static double parted(double by) {
        return (1 - LEFT) * (by - KeptOverlap.LEAST * WIDTH);
    }

    /** Each of the two moves by the share of the other's mass. */
    @Test
    void twoInSpacePartByTheirMasses() {
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 0.25, 0);
        contacts.groundStart = 1;
        overlap(island.contact(1, 2, 0.5, 0.5), 0.03, 0);
        contacts.groundStart = 1;
        part();
        double opened = parted(0.03);
        assertThat(dense.displacements()[4]).isCloseTo(-0.8 * opened, within(ROUND_OFF));
        assertThat(dense.displacements()[7]).isCloseTo(0.2 * opened, within(ROUND_OFF));
    }

    /** Both points of any contact open by their shares, with both pushes at once. */
    @Test
    void bothPointsOpenByTheirShares() {
        SplittableRandom random = new SplittableRandom(1);
        int both = 0;
        for (int i = 0; i < 300; i++) {
            island.bodies(random, 2);
            island.body(1, random.nextDouble(0.5, 2), random.nextDouble(0.5, 2));
            island.body(2, random.nextDouble(0.5, 2), random.nextDouble(0.5, 2));
            int row = island.contact(random, 1, 2);
            double first = random.nextDouble(0.02, 0.03);
            double second = random.nextDouble(0.02, 0.03);
            overlap(row, first, second);
            contacts.groundStart = 1;
            part();
            double[] now = dense.displacements();
            double opened0 = dense.along(row, 0, now);
            double opened1 = dense.along(row, 1, now);
            int at = row * PackedContacts.STRIDE;
            double[] d = contacts.data;
            double push0 =
                    d[at + PackedContacts.M00] * parted(first)
                            + d[at + PackedContacts.M01] * parted(second);
            double push1 =
                    d[at + PackedContacts.M01] * parted(first)
                            + d[at + PackedContacts.M11] * parted(second);
            if (push0 > 0 && push1 > 0) {
                both++;
                assertThat(opened0).isCloseTo(parted(first), within(ROUND_OFF));
                assertThat(opened1).isCloseTo(parted(second), within(ROUND_OFF));
                double[] change = dense.change(new double[] {push0, push1, 0, 0});
                for (int k = 3; k < now.length; k++) {
                    assertThat(now[k]).isCloseTo(change[k], within(ROUND_OFF));
                }
            } else {
                // One point opens alone and takes the other one along.
                assertThat(Math.min(opened0 / parted(first), opened1 / parted(second)))
                        .isGreaterThan(0.999);
            }
        }
        assertThat(both).isGreaterThan(100);
    }

    /** Several contacts push the middle one of three: each takes half of its share. */
    @Test
    void manyPushesDoNotOvershoot() {
        beginFree(3);
        overlap(island.contact(1, 2, 0.5, 0.5), 0.02, 0);
        overlap(island.contact(2, 3, 0.5, 0.5), 0.02, 0);
        contacts.groundStart = 2;
        part();
        // A share of 25·h/(1 + 25·h) = 0.2 is less than the half that two pushes could take.
        double[] now = dense.displacements();
        assertThat(now[7]).isCloseTo(0, within(ROUND_OFF));
        // Seen from the middle body each gap closes half as fast, since the other half comes back.
        double left = Math.pow(1 - 0.5 * Recovery.RATE * H / (1 + Recovery.RATE * H), 12);
        double opened = (1 - left) * (0.02 - KeptOverlap.LEAST * WIDTH);
        assertThat(now[10]).isCloseTo(opened, within(ROUND_OFF));
        assertThat(now[4]).isCloseTo(-opened, within(ROUND_OFF));
    }

    /** The fastest body moves at three widths a second at most, and all others in proportion. */
    @Test
    void theFastestSetsThePace() {
        beginFree(4);
        overlap(island.contact(1, 2, 0.5, 0.5), 0.4, 0);
        overlap(island.contact(3, 4, 0.5, 0.5), 0.1, 0);
        contacts.groundStart = 2;
        part();
        double[] now = dense.displacements();
        assertThat(now[7]).isCloseTo(MOST, within(1e-8 * MOST));
        assertThat(now[13] / now[7]).isCloseTo(parted(0.1) / parted(0.4), within(1e-9));
    }

    /** A body that hardly moves any more stays: at 0.04 of the greatest rate. */
    @ParameterizedTest
    @CsvSource({"0.9, false", "1.1, true"})
    void whatHardlyMovesStays(double times, boolean isMoved) {
        double way = times * 0.04 * MOST;
        double overlaps = 2 * way / (1 - LEFT) + KeptOverlap.LEAST * WIDTH;
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 1, 0);
        overlap(island.contact(1, 2, 0.5, 0.5), overlaps, 0);
        contacts.groundStart = 1;
        part();
        assertThat(dense.displacements()[7]).isCloseTo(isMoved ? way : 0, within(ROUND_OFF));
        assertThat(overlap.isBlocked(H)).isEqualTo(!isMoved);
    }

    /** Between two immovable bodies a body cannot move and is reported as blocked. */
    @Test
    void whatHasNoRoomIsBlocked() {
        island.begin(1);
        island.body(1, 1, 0);
        overlap(island.onGround(1, 0.5, 0.5), 0.015, 0);
        contacts.isAnyCrushed = true;
        int above = island.onGround(1, 0.5, 0.5);
        contacts.data[above * PackedContacts.STRIDE + PackedContacts.NY] = -1;
        overlap(above, 0.015, 0);
        overlap.prepare(true);
        assertThat(overlap.isBlocked(H)).isTrue();
        contacts.firstSubstep[above] = 1;
        assertThat(overlap.isBlocked(H)).isFalse();
        assertThat(dense.displacements()[4]).isGreaterThan(0);
    }

    /** Turning counts as a way of the outline, one metre from the centre. */
    @Test
    void turningIsAWay() {
        island.begin(2);
        island.body(1, 1e-3, 1);
        island.body(2, 1e-3, 1e-3);
        int row = island.contact(1, 2, 1, 1);
        overlap(row, 0.4, 0);
        contacts.points[row] = 1;
        contacts.groundStart = 1;
        part();
        assertThat(Math.abs(dense.displacements()[5]) + Math.abs(dense.displacements()[4]))
                .isCloseTo(MOST, within(1e-8 * MOST));
    }

    /** Masses that differ by more than thirty times are not treated as a jam. */
    @Test
    void onlyEqualsAreJammed() {
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 29, 0);
        overlap(island.contact(1, 2, 0.5, 0.5), 0.1, 0);
        contacts.isAnyCrushed = true;
        overlap.prepare(true);
        assertThat(overlap.isJammed()).isTrue();
        overlap.prepare(false);
        assertThat(overlap.isJammed()).isFalse();
        island.body(2, 31, 0);
        overlap.prepare(true);
        assertThat(overlap.isJammed()).isFalse();
        contacts.isAnyCrushed = false;
        island.body(2, 1, 0);
        overlap.prepare(true);
        assertThat(overlap.isJammed()).isFalse();
        assertThat(overlap.isBlocked(H)).isFalse();
    }
}
