package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;

import java.util.Arrays;
import java.util.SplittableRandom;

/** Random contacts, compared with Coulomb's law over their written-out rows. */
class SweptContactTest {

    private static final double H = 1.0 / 240;
    private static final double ROUND_OFF = 1e-11;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final ContactSweep sweep = ContactSweepTest.sweep(island, true);

    /** A contact with all properties, and with earlier impulses. */
    private int contact(SplittableRandom random, int a, int b) {
        int row = island.contact(random, a, b);
        island.set(row, PackedContacts.GIVE, random.nextDouble(0.1));
        island.writeMasses(row);
        island.set(row, PackedContacts.FRICTION, random.nextDouble(2));
        island.set(row, PackedContacts.GAP0, H * random.nextDouble(-0.5, 0.5));
        island.set(row, PackedContacts.GAP1, H * random.nextDouble(-0.5, 0.5));
        island.set(row, PackedContacts.NEARING, random.nextDouble(0.2));
        island.set(row, PackedContacts.IMPULSE0, random.nextDouble(0.3));
        island.set(row, PackedContacts.IMPULSE1, random.nextDouble(0.3));
        island.set(row, PackedContacts.IMPULSE_T, random.nextDouble(-0.2, 0.2));
        contacts.surface[row] = random.nextDouble(-0.5, 0.5);
        return row;
    }

    /** w = v + gap/h − nearing + give·j of a point, which may close by its gap only. */
    private double rest(int row, int point) {
        double gap = Math.max(0, island.of(row, PackedContacts.GAP0 + point));
        double give =
                island.of(row, PackedContacts.GIVE)
                        * island.of(row, PackedContacts.IMPULSE0 + point);
        double speed = dense.speed(row, point);
        return speed + gap / H - island.of(row, PackedContacts.NEARING) + give;
    }

    private void assertPushes(int row, int point, double tolerance) {
        double impulse = island.of(row, PackedContacts.IMPULSE0 + point);
        double rest = rest(row, point);
        assertThat(impulse).isNotNegative();
        assertThat(rest).isGreaterThan(-tolerance);
        assertThat(Math.min(impulse, rest)).isLessThan(tolerance);
    }

    /** Friction is bounded by the present load; then both points are solved at once. */
    @Test
    void onePassSolvesAContact() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 3_000; i++) {
            island.bodies(random, 2);
            int row = contact(random, i % 3 == 0 ? 0 : 1, 2);
            double load =
                    island.of(row, PackedContacts.IMPULSE0)
                            + island.of(row, PackedContacts.IMPULSE1);
            double slides = dense.speed(row, DenseRows.TANGENT) - contacts.surface[row];
            double wanted =
                    island.of(row, PackedContacts.IMPULSE_T)
                            - island.of(row, PackedContacts.MASS_T) * slides;
            double cone = island.of(row, PackedContacts.FRICTION) * load;
            double rubs = Math.max(-cone, Math.min(cone, wanted));
            dense.begin();
            sweep.run(H, H, 0, 0, 0, 0, 1);
            dense.assertImpulsesTellAll(ROUND_OFF);
            assertPushes(row, 0, ROUND_OFF);
            assertPushes(row, 1, ROUND_OFF);
            // The compliance of friction leaves 10⁻¹⁰ of its impulse.
            assertThat(island.of(row, PackedContacts.IMPULSE_T)).isCloseTo(rubs, within(1e-9));
            assertThat(contacts.work.contactSolves).isEqualTo(i + 1);
        }
    }

    @Test
    void onePassSolvesASinglePoint() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 1_000; i++) {
            island.bodies(random, 2);
            int row = contact(random, 1, 2);
            contacts.points[row] = 1;
            island.set(row, PackedContacts.IMPULSE1, 0);
            island.set(row, PackedContacts.M00, 1 / island.of(row, PackedContacts.K00));
            dense.begin();
            sweep.run(H, H, 0, 0, 0, 0, 1);
            dense.assertImpulsesTellAll(ROUND_OFF);
            assertPushes(row, 0, ROUND_OFF);
            assertThat(island.of(row, PackedContacts.IMPULSE1)).isZero();
        }
    }

    /** One after the other: the second point includes the effect of the first one. */
    @Test
    void pointsInTurnAreSolvedInTurn() {
        SplittableRandom random = new SplittableRandom(3);
        ContactSweep inTurn = ContactSweepTest.sweep(island, false);
        for (int i = 0; i < 1_000; i++) {
            island.bodies(random, 2);
            int row = contact(random, 1, 2);
            island.set(row, PackedContacts.FRICTION, 0);
            island.set(row, PackedContacts.IMPULSE_T, 0);
            double old0 = island.of(row, PackedContacts.IMPULSE0);
            double first = old0 - rest(row, 0) / island.of(row, PackedContacts.K00);
            dense.begin();
            inTurn.run(H, H, 0, 0, 0, 0, 1);
            dense.assertImpulsesTellAll(ROUND_OFF);
            double expected = Math.max(0, first);
            assertThat(island.of(row, PackedContacts.IMPULSE0))
                    .isCloseTo(expected, within(ROUND_OFF));
            assertPushes(row, 1, ROUND_OFF);
        }
    }

    /** Bodies of a heap: when no contact is due any more, all obey Coulomb's law. */
    @ParameterizedTest
    @ValueSource(ints = {6, 80})
    void passesEndAtCoulombsLaw(int count) {
        SplittableRandom random = new SplittableRandom(count);
        for (int i = 0; i < 600 / count; i++) {
            island.bodies(random, count);
            for (int entry = 1; entry <= count; entry++) {
                contact(random, entry - 1, entry);
                if (entry > 2 && random.nextInt(4) == 0) {
                    contact(random, random.nextInt(1, entry - 1), entry);
                }
            }
            contacts.groundStart = contacts.count;
            for (int row = 0; row < contacts.count; row++) {
                // Small enough that friction does not let loads grow without end; and through the
                // centres, since a contact's friction is solved before its load.
                island.set(row, PackedContacts.FRICTION, random.nextDouble(0.2));
                island.set(row, PackedContacts.LEVER_TA, 0);
                island.set(row, PackedContacts.LEVER_TB, 0);
                island.writeMasses(row);
            }
            dense.begin();
            sweep.run(H, H, 0, 0, 1e-13, 1e-13, 1_000_000);
            dense.assertImpulsesTellAll(1e-9);
            for (int row = 0; row < contacts.count; row++) {
                assertCoulomb(row);
            }
        }
    }

    private void assertCoulomb(int row) {
        double tolerance = 1e-8;
        assertPushes(row, 0, tolerance);
        assertPushes(row, 1, tolerance);
        double load =
                island.of(row, PackedContacts.IMPULSE0) + island.of(row, PackedContacts.IMPULSE1);
        double cone = island.of(row, PackedContacts.FRICTION) * load;
        double rubs = island.of(row, PackedContacts.IMPULSE_T);
        double slides = dense.speed(row, DenseRows.TANGENT) - contacts.surface[row];
        assertThat(Math.abs(rubs)).isLessThan(cone + tolerance);
        boolean holds = Math.abs(slides) < tolerance;
        boolean isBraked = Math.abs(rubs) > cone - tolerance && slides * rubs <= tolerance;
        assertThat(holds || isBraked).as("slides at %s by %s of %s", slides, rubs, cone).isTrue();
    }

    /** A driven body presses by no more than its bound, at both points in proportion. */
    @Test
    void pressesAreBounded() {
        SplittableRandom random = new SplittableRandom(4);
        int bounded = 0;
        for (int i = 0; i < 500; i++) {
            island.bodies(random, 2);
            int driven = 1 + i % 2;
            island.body(driven, 0, 0);
            int row = contact(random, 1, 2);
            island.set(row, PackedContacts.FRICTION, 0);
            island.set(row, PackedContacts.IMPULSE_T, 0);
            island.writeMasses(row);
            double[] before = contacts.data.clone();
            double[] moving = motions.data.clone();
            sweep.run(H, H, 0, 0, 0, 0, 1);
            double free =
                    island.of(row, PackedContacts.IMPULSE0)
                            + island.of(row, PackedContacts.IMPULSE1);
            double first = island.of(row, PackedContacts.IMPULSE0);
            System.arraycopy(before, 0, contacts.data, 0, before.length);
            System.arraycopy(moving, 0, motions.data, 0, moving.length);
            sweep.limitPresses(0.3);
            dense.begin();
            sweep.run(H, H, 0, 0, 0, 0, 1);
            sweep.limitPresses(Double.POSITIVE_INFINITY);
            dense.assertImpulsesTellAll(ROUND_OFF);
            double share = Math.min(1, 0.3 / free);
            bounded += share < 1 ? 1 : 0;
            assertThat(island.of(row, PackedContacts.IMPULSE0))
                    .isCloseTo(share * first, within(ROUND_OFF));
            assertThat(island.of(row, PackedContacts.IMPULSE1))
                    .isCloseTo(share * (free - first), within(ROUND_OFF));
        }
        assertThat(bounded).isBetween(100, 450);
    }

    /** A contact of two dynamic bodies has no bound of a press. */
    @Test
    void onlyDrivenBodiesPress() {
        SplittableRandom random = new SplittableRandom(5);
        island.bodies(random, 2);
        int row = contact(random, 1, 2);
        island.set(row, PackedContacts.IMPULSE0, 0.3);
        sweep.limitPresses(1e-9);
        dense.begin();
        sweep.run(H, H, 0, 0, 0, 0, 1);
        assertPushes(row, 0, ROUND_OFF);
        assertPushes(row, 1, ROUND_OFF);
    }

    /** By its closing speed, less the part that a gap allows, times h; in widths of the contact. */
    @Test
    void whatSinksIsTold() {
        island.begin(1);
        island.body(1, 1, 1);
        int row = island.onGround(1, 0.5, 0.5);
        island.set(row, PackedContacts.WIDTH, 2);
        sweep.run(H, H, 0, 0, 0, 0, 0);
        motions.data[Motions.STRIDE + Motions.VY] = -1;
        assertThat(sweep.isSinking(H, 0, 0.49 * H)).isTrue();
        assertThat(sweep.isSinking(H, 0, 0.51 * H)).isFalse();
        assertThat(sweep.isSinking(2 * H, 0, 0.99 * H)).isTrue();
        island.set(row, PackedContacts.GAP0, 0.5 * H);
        island.set(row, PackedContacts.GAP1, 0.5 * H);
        sweep.run(H, H, 0, 0, 0, 0, 0);
        assertThat(sweep.isSinking(H, 0, 0.26 * H)).isFalse();
        assertThat(sweep.isSinking(H, 0, 0.24 * H)).isTrue();
        // The right corner sinks faster: by half a metre times 1 rad/s.
        motions.data[Motions.STRIDE + Motions.SPIN] = -1;
        assertThat(sweep.isSinking(H, 0, 0.49 * H)).isTrue();
        assertThat(sweep.isSinking(H, 0, 0.51 * H)).isFalse();
        contacts.firstSubstep[row] = 1;
        assertThat(sweep.isSinking(H, 0, 0)).isFalse();
        assertThat(sweep.isSinking(H, 1, 0)).isTrue();
    }

    /** One pass back: of two contacts the upper one is solved first. */
    @Test
    void onePassTellsTheGreatestChange() {
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 0.5, 0);
        motions.data[Motions.STRIDE + Motions.VY] = -1;
        motions.data[2 * Motions.STRIDE + Motions.VY] = -4;
        island.onGround(1, 0.5, 0.5);
        island.contact(1, 2, 0.5, 0.5);
        contacts.groundStart = 2;
        // 3 m/s over 1.5/kg are 2 N·s: the lower body is then at -3 m/s and needs 3 N·s.
        assertThat(sweep.once(H, 0)).isCloseTo(2 + 3, within(ROUND_OFF));
        assertThat(sweep.change(2)).isCloseTo(1, within(ROUND_OFF));
        assertThat(motions.data[Motions.STRIDE + Motions.VY]).isCloseTo(0, within(ROUND_OFF));
    }

    /** The change of a body's outline counts, one metre from its centre, also by friction. */
    @Test
    void turningCountsAsChange() {
        SplittableRandom random = new SplittableRandom(6);
        for (int i = 0; i < 200; i++) {
            island.bodies(random, 2);
            int row = contact(random, 1, 2);
            double[] before = dense.impulses();
            sweep.once(H, 0);
            double[] after = dense.impulses();
            for (int entry = 1; entry <= 2; entry++) {
                int first = entry == 1 ? PackedContacts.LEVER_A0 : PackedContacts.LEVER_B0;
                int tangent = entry == 1 ? PackedContacts.LEVER_TA : PackedContacts.LEVER_TB;
                double j0 = after[0] - before[0];
                double j1 = after[1] - before[1];
                double jt = after[2] - before[2];
                double turn = island.of(row, first) * j0 + island.of(row, first + 2) * j1;
                turn += island.of(row, tangent) * jt;
                int at = entry * Motions.STRIDE;
                double change =
                        motions.data[at + Motions.INVERSE_MASS] * (Math.abs(j0 + j1) + Math.abs(jt))
                                + motions.data[at + Motions.INVERSE_INERTIA] * Math.abs(turn);
                assertThat(sweep.change(entry)).isCloseTo(change, within(ROUND_OFF));
            }
        }
    }

    /** Only contacts that were measured again, and those of the bodies that they move. */
    @Test
    void newContactsAreSolvedFirst() {
        island.begin(4);
        for (int entry = 1; entry <= 4; entry++) {
            island.body(entry, 1, 0);
            motions.data[entry * Motions.STRIDE + Motions.VY] = -1;
        }
        island.onGround(1, 0.5, 0.5);
        island.contact(1, 2, 0.5, 0.5);
        island.onGround(3, 0.5, 0.5);
        island.onGround(4, 0.5, 0.5);
        contacts.groundStart = 4;
        contacts.firstSubstep[3] = 1;
        Arrays.fill(contacts.isNew, false);
        contacts.isNew[0] = true;
        contacts.isNew[3] = true;
        sweep.runNew(H, 0, 0, 1e-9, 1e-9, 1_000);
        assertThat(motions.data[Motions.STRIDE + Motions.VY]).isCloseTo(0, within(1e-8));
        assertThat(motions.data[2 * Motions.STRIDE + Motions.VY]).isCloseTo(0, within(1e-8));
        assertThat(motions.data[3 * Motions.STRIDE + Motions.VY]).isEqualTo(-1);
        // A body that joins later is not present yet.
        assertThat(motions.data[4 * Motions.STRIDE + Motions.VY]).isEqualTo(-1);
        contacts.isNew[0] = false;
        sweep.runNew(H, 1, 0, 1e-9, 1e-9, 1_000);
        assertThat(motions.data[4 * Motions.STRIDE + Motions.VY]).isZero();
    }

    /** In a crowd a parting contact without a load is skipped until it closes again. */
    @Test
    void whatPartsInACrowdIsNotSolved() {
        int crowd = 70;
        island.begin(crowd);
        for (int entry = 1; entry <= crowd; entry++) {
            island.body(entry, 1, 0);
            motions.data[entry * Motions.STRIDE + Motions.VY] = 0.01 * entry;
            island.contact(entry - 1, entry, 0.5, 0.5);
        }
        contacts.groundStart = crowd;
        contacts.work.contactSolves = 0;
        sweep.run(H, H, 0, 0, 1e-9, 1e-9, 1_000);
        assertThat(contacts.work.contactSolves).isZero();
        // The uppermost body meets the one below, and some of those below that.
        motions.data[crowd * Motions.STRIDE + Motions.VY] = -0.5;
        sweep.run(H, H, 0, 0, 1e-9, 1e-9, 10_000);
        assertThat(contacts.work.contactSolves).isPositive();
        for (int row = 0; row < crowd; row++) {
            assertThat(motions.parting(contacts, row, 0)).isGreaterThan(-1e-7);
        }
    }
}
