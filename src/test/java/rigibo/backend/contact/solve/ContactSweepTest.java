package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.contact.row.SharedRows;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.storage.Bodies;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * Single contacts, compared with the solution of their small problems, and the number of solutions.
 */
class ContactSweepTest {

    private static final double H = 1.0 / 240;

    /** A few roundings of numbers of the order of one. */
    private static final double ROUND_OFF = 1e-12;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final ContactSweep sweep = sweep(island, true);

    /** Passes over an island; as a block, both points of a contact are solved at once. */
    static ContactSweep sweep(PackedIsland island, boolean isBlock) {
        return new ContactSweep(
                new Bodies(Effects.of(new Contacts())),
                island.motions,
                island.contacts,
                new NoRubbing(),
                isBlock,
                new SharedRows(null, island.contacts));
    }

    /** w ≥ 0, j ≥ 0, w·j = 0 for both points, in each of the four cases. */
    @Test
    void twoPointsOfOneContactAnswerAsOne() {
        SplittableRandom random = new SplittableRandom(1);
        int[] asked = new int[4];
        for (int i = 0; i < 10_000; i++) {
            island.begin(1);
            island.body(1, random.nextDouble(0.1, 10), random.nextDouble(0.1, 10));
            int row = island.onGround(1, random.nextDouble(0.1, 1), random.nextDouble(0.1, 1));
            motions.data[Motions.STRIDE + Motions.VY] = random.nextDouble(-1, 1);
            motions.data[Motions.STRIDE + Motions.SPIN] = random.nextDouble(-1, 1);
            sweep.run(H, H, 0, 1, 0, 0, 1);
            int loaded = 0;
            for (int point = 0; point < 2; point++) {
                double impulse =
                        contacts.data[
                                row * PackedContacts.STRIDE + PackedContacts.IMPULSE0 + point];
                double parting = motions.parting(contacts, row, point);
                assertThat(impulse).isNotNegative();
                assertThat(parting).isGreaterThanOrEqualTo(-ROUND_OFF);
                assertThat(impulse * parting).isCloseTo(0, within(ROUND_OFF));
                loaded += impulse > 0 ? 1 + point : 0;
            }
            asked[loaded]++;
        }
        assertThat(Arrays.stream(asked).min().orElseThrow()).isGreaterThan(500);
    }

    /** A sliding body is braked by μ times the load, and a held one does not move. */
    @Test
    void frictionHoldsUpToItsConeAndBrakesBeyond() {
        SplittableRandom random = new SplittableRandom(2);
        int held = 0;
        for (int i = 0; i < 1_000; i++) {
            island.begin(1);
            island.body(1, 1, 0);
            int row = island.onGround(1, 0.5, 0.5);
            int at = row * PackedContacts.STRIDE;
            double friction = random.nextDouble(0.1, 1);
            double speed = random.nextDouble(-1, 1);
            contacts.data[at + PackedContacts.FRICTION] = friction;
            contacts.data[at + PackedContacts.MASS_T] = 1;
            motions.data[Motions.STRIDE + Motions.VX] = speed;
            motions.data[Motions.STRIDE + Motions.VY] = -1;
            sweep.run(H, H, 0, 1, 0, 0, 50);
            // A mass of 1 kg at 1 m/s is stopped by 1 N·s.
            double left = Math.max(0, Math.abs(speed) - friction) * Math.signum(speed);
            assertThat(motions.data[Motions.STRIDE + Motions.VX]).isCloseTo(left, within(1e-9));
            held += left == 0 ? 1 : 0;
        }
        assertThat(held).isBetween(300, 700);
    }

    /** A gap may close within the substep, and no faster. */
    @Test
    void gapMayCloseWithinTheSubstep() {
        island.begin(1);
        island.body(1, 1, 0);
        int row = island.onGround(1, 0.5, 0.5);
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] = 0.01;
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP1] = 0.01;
        motions.data[Motions.STRIDE + Motions.VY] = -10;
        sweep.run(H, H, 0, 1, 0, 0, 1);
        assertThat(motions.data[Motions.STRIDE + Motions.VY]).isCloseTo(-0.01 / H, within(1e-9));
    }

    /** In a column at rest each contact is solved once, and another pass finds none due. */
    @Test
    void whatIsQuietIsLeftAlone() {
        column(20);
        sweep.run(H, H, 0, 1, 1e-9, 1e-9, 10_000);
        contacts.work.contactSolves = 0;
        sweep.run(H, H, 0, 1, 1e-9, 1e-9, 10_000);
        assertThat(contacts.work.contactSolves).isEqualTo(20);
    }

    /** The lowest of n equal bodies is held by n of their momenta, N·s. */
    @Test
    void columnIsHeldByWhatLiesOnIt() {
        int count = 20;
        column(count);
        sweep.run(H, H, 0, 1, 1e-12, 1e-12, 100_000);
        for (int row = 0; row < count; row++) {
            int at = row * PackedContacts.STRIDE;
            double load =
                    contacts.data[at + PackedContacts.IMPULSE0]
                            + contacts.data[at + PackedContacts.IMPULSE1];
            // 20 contacts may each miss 1e-12 m/s, which a column adds up 20 times over: 4e-10.
            assertThat(load).isCloseTo(count - row, within(1e-7));
        }
    }

    /**
     * The residual of a contact does not exceed the allowance; for one that overlaps by a hundredth
     * of its width, in a crowd, that is three thousandths of the usual one.
     */
    @Test
    void whatOverlapsIsSolvedStrictly() {
        int crowd = 65;
        double quiet = 0.1;
        double strictly = 0.003 * quiet;
        SplittableRandom random = new SplittableRandom(3);
        int sloppy = 0;
        for (int i = 0; i < 200; i++) {
            column(crowd);
            for (int body = 1; body <= crowd; body++) {
                motions.data[body * Motions.STRIDE + Motions.VY] = random.nextDouble(-1, 0);
            }
            int deep = random.nextInt(crowd);
            contacts.data[deep * PackedContacts.STRIDE + PackedContacts.GAP0] = -0.01;
            contacts.data[deep * PackedContacts.STRIDE + PackedContacts.GAP1] = -0.01;
            sweep.run(H, H, 0, 1, quiet, quiet, 100_000);
            for (int row = 0; row < crowd; row++) {
                double missed = -motions.parting(contacts, row, 0);
                assertThat(missed).isLessThan((row == deep ? strictly : quiet) + 1e-12);
                sloppy += missed > 10 * strictly ? 1 : 0;
            }
        }
        assertThat(sloppy).as("contacts that missed by more than they may in overlap").isPositive();
    }

    /**
     * The allowance is three tenths of the relative speed of the two bodies, within two bounds:
     * fast bodies above do not make the solution below coarse.
     */
    @Test
    void whatHardlyMovesIsSolvedFinely() {
        int crowd = 70;
        double quiet = 0.1;
        SplittableRandom random = new SplittableRandom(5);
        double[] most = new double[crowd];
        int fine = 0;
        for (int i = 0; i < 100; i++) {
            column(crowd);
            double before = 0;
            for (int body = 1; body <= crowd; body++) {
                double speed = body < crowd / 2 ? random.nextDouble(-0.02, 0) : -1 - 0.1 * body;
                motions.data[body * Motions.STRIDE + Motions.VY] = speed;
                double between = Math.abs(speed - before);
                most[body - 1] = Math.min(quiet, Math.max(0.3 * between, 0.05 * quiet));
                before = speed;
            }
            sweep.run(H, H, 0, 1, quiet, 0.05 * quiet, 100_000);
            for (int row = 0; row < crowd; row++) {
                double missed = -motions.parting(contacts, row, 0);
                assertThat(missed).isLessThan(most[row] + ROUND_OFF);
                fine += most[row] < quiet / 10 ? 1 : 0;
            }
        }
        assertThat(fine).as("contacts of which a tenth was asked, or less").isGreaterThan(3_000);
    }

    /**
     * Two columns that fall side by side touch with no force between them. Round-off of their
     * sideways speeds must not change which contacts are solved, nor how often.
     */
    @Test
    void roundOffBetweenNeighboursChangesNoWork() {
        SplittableRandom random = new SplittableRandom(4);
        int height = 33;
        long solves = 0;
        for (int i = 0; i < 20; i++) {
            columns(height);
            for (int body = 1; body <= 2 * height; body++) {
                double noise = i == 0 ? 0 : random.nextDouble(-1e-14, 1e-14);
                motions.data[body * Motions.STRIDE + Motions.VX] = noise;
            }
            contacts.work.contactSolves = 0;
            sweep.run(H, H, 0, 1, 0.01, 0.01, 10_000);
            sweep.run(H, H / 2, 0, 1, 0.01, 0.01, 10_000);
            solves = i == 0 ? contacts.work.contactSolves : solves;
            assertThat(contacts.work.contactSolves).as("noise %d", i).isEqualTo(solves);
        }
        assertThat(solves).isGreaterThan(2 * height);
    }

    /** Two columns of bodies that do not turn, each body beside one of the other column. */
    private void columns(int height) {
        island.begin(2 * height);
        for (int body = 1; body <= 2 * height; body++) {
            island.body(body, 1, 0);
            motions.data[body * Motions.STRIDE + Motions.VY] = -1;
        }
        for (int body = 1; body <= height; body++) {
            island.contact(body - 1, body, 0.5, 0.5);
            island.contact(body == 1 ? 0 : height + body - 1, height + body, 0.5, 0.5);
            int at = island.contact(body, height + body, 0, 0) * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.NX] = 1;
            contacts.data[at + PackedContacts.NY] = 0;
        }
        contacts.groundStart = contacts.count;
    }

    /**
     * A row that yields to a force yields at the same speed in half a kick, with half of the
     * impulse.
     */
    @Test
    void whatGivesWayGoesByItsForce() {
        double give = 0.01;
        for (double kick : new double[] {H, H / 2}) {
            island.begin(1);
            island.body(1, 1, 0);
            int row = island.onGround(1, 0.5, 0.5);
            int at = row * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.GIVE] = give;
            double force = 3 / H;
            contacts.data[at + PackedContacts.IMPULSE0] = force * kick;
            sweep.run(H, kick, 0, 1, 0, 0, 1);
            assertThat(motions.data[Motions.STRIDE + Motions.VY])
                    .isCloseTo(-give * force * H, within(1e-12));
        }
    }

    /** Bodies of 1 kg one on the other, all at 1 m/s downwards, with the lowest contact first. */
    private void column(int count) {
        island.begin(count);
        for (int body = 1; body <= count; body++) {
            island.body(body, 1, 0);
            motions.data[body * Motions.STRIDE + Motions.VY] = -1;
        }
        for (int body = 1; body <= count; body++) {
            island.contact(body - 1, body, 0.5, 0.5);
        }
        contacts.groundStart = contacts.count;
    }
}
