package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

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

import java.util.SplittableRandom;

/** Random small islands that are solved whole, compared with the law of their written-out rows. */
class DirectSolverTest {

    private static final double H = 1.0 / 240;
    private static final double SETTLED = 1e-11;
    private static final double PLENTY = 1e12;

    /** Speed that a body gains by gravity in a step, m/s. */
    private static final double GAINED = 9.81 / 60;

    /** Residuals and loads of up to 20 contacts, some of which share their loads. */
    private static final double SOLVED = 1e-8;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final OverlapSolver overlap =
            new OverlapSolver(bodies, motions, contacts, Accuracy.GAME);
    private final DirectSolver direct = new DirectSolver(motions, contacts, overlap, 16);
    private final ContactSweep sweep = ContactSweepTest.sweep(island, true);

    /** A chain from the ground with some more contacts, gaps, and earlier loads. */
    private void heap(SplittableRandom random, int count, double friction) {
        island.bodies(random, count);
        for (int entry = 1; entry <= count; entry++) {
            contact(random, entry - 1, entry, friction);
            if (entry > 1 && random.nextInt(3) == 0) {
                contact(random, random.nextInt(entry), entry, friction);
            }
        }
    }

    private void contact(SplittableRandom random, int a, int b, double friction) {
        int row = island.contact(random, a, b);
        island.set(row, PackedContacts.GIVE, 0.01);
        island.writeMasses(row);
        contacts.points[row] = 1 + random.nextInt(2);
        if (contacts.points[row] == 1) {
            island.set(row, PackedContacts.M00, 1 / island.of(row, PackedContacts.K00));
        }
        island.set(row, PackedContacts.FRICTION, friction);
        island.set(row, PackedContacts.GAP0, H * random.nextDouble(-0.3, 0.3));
        island.set(row, PackedContacts.GAP1, H * random.nextDouble(-0.3, 0.3));
        island.set(row, PackedContacts.NEARING, random.nextDouble(0.1));
        island.set(row, PackedContacts.IMPULSE0, random.nextDouble(0.1));
        contacts.surface[row] = random.nextDouble(-0.3, 0.3);
    }

    /** v + gap/h − nearing of a point. */
    private double closes(int row, int point) {
        double gap = Math.max(0, island.of(row, PackedContacts.GAP0 + point));
        return dense.speed(row, point) + gap / H - island.of(row, PackedContacts.NEARING);
    }

    private void assertObeys() {
        dense.assertImpulsesTellAll(SOLVED);
        for (int row = 0; row < contacts.count; row++) {
            double load = 0;
            for (int point = 0; point < contacts.points[row]; point++) {
                double impulse = island.of(row, PackedContacts.IMPULSE0 + point);
                double rest = closes(row, point) + island.of(row, PackedContacts.GIVE) * impulse;
                assertThat(impulse).isNotNegative();
                assertThat(rest).isGreaterThan(-SOLVED);
                assertThat(Math.min(impulse, rest)).isLessThan(SOLVED);
                load += impulse;
            }
            double cone = island.of(row, PackedContacts.FRICTION) * load;
            double rubs = island.of(row, PackedContacts.IMPULSE_T);
            double slides = dense.speed(row, DenseRows.TANGENT) - contacts.surface[row];
            assertThat(Math.abs(rubs)).isLessThan(cone + SOLVED);
            boolean isBraked = Math.abs(rubs) > cone - SOLVED && slides * rubs <= SOLVED;
            assertThat(Math.abs(slides) < SOLVED || isBraked).isTrue();
        }
    }

    /** A pass drops rows that carry nothing, and all other rows are eliminated. */
    private void solve(int rounds) {
        assertThat(direct.prepare(PLENTY, false, GAINED)).isTrue();
        direct.begin();
        dense.begin();
        for (int round = 0; round < rounds; round++) {
            sweep.run(H, H, 0, 0, 0, 0, 1);
            direct.solve(H, 0, SETTLED);
        }
        assertThat(direct.isSpent()).isFalse();
    }

    /** w ≥ 0, j ≥ 0, w·j = 0. */
    @Test
    void smoothHeapsObeyTheirLaw() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 200; i++) {
            heap(random, 2 + random.nextInt(9), 0);
            solve(30);
            assertObeys();
        }
    }

    /** Rounds bound friction by the load of the round before, until it no longer changes. */
    @Test
    void rubbingHeapsObeyCoulombsLaw() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 200; i++) {
            heap(random, 2 + random.nextInt(6), 0.1);
            solve(200);
            assertObeys();
        }
    }

    /** From the present impulses on, a row yields by the change of its load alone. */
    @Test
    void nearbyImpulsesGiveWayByTheirChange() {
        SplittableRandom random = new SplittableRandom(2);
        int carried = 0;
        for (int i = 0; i < 50; i++) {
            heap(random, 2 + random.nextInt(6), 0);
            solve(30);
            double[] kept = dense.impulses();
            motions.data[Motions.STRIDE + Motions.VX] += 1e-4;
            direct.prepare(PLENTY, true, GAINED);
            direct.begin();
            direct.solve(H, 0, SETTLED);
            for (int row = 0; row < contacts.count; row++) {
                double more = island.of(row, PackedContacts.IMPULSE0) - kept[DenseRows.KINDS * row];
                if (island.of(row, PackedContacts.IMPULSE0) > 0.1) {
                    carried++;
                    double gives = island.of(row, PackedContacts.GIVE) * more;
                    assertThat(closes(row, 0) + gives).isCloseTo(0, within(SOLVED));
                }
            }
        }
        assertThat(carried).isGreaterThan(50);
    }

    /** Two contacts in place of one share a change of their load equally. */
    @Test
    void redundantContactsKeepTheSharesThatTheyHave() {
        island.begin(1);
        island.body(1, 1, 0);
        island.motions.data[Motions.STRIDE + Motions.VY] = -0.1;
        double[] carried = {0.7, 0.3};
        for (int row = 0; row < 2; row++) {
            island.onGround(1, 0.5, 0.5);
            island.set(row, PackedContacts.MASS_T, 1);
            island.set(row, PackedContacts.IMPULSE0, carried[row]);
        }
        direct.prepare(PLENTY, true, GAINED);
        direct.begin();
        direct.solve(H, 0, SETTLED);
        for (int row = 0; row < 2; row++) {
            assertThat(island.of(row, PackedContacts.IMPULSE0))
                    .isCloseTo(carried[row] + 0.05, within(SOLVED));
        }
    }

    /** Newton's method from the solution of a slightly different problem. */
    @Test
    void newtonFindsWhatIsNear() {
        SplittableRandom random = new SplittableRandom(4);
        int found = 0;
        for (int i = 0; i < 100; i++) {
            heap(random, 2 + random.nextInt(6), 0.1);
            solve(200);
            for (int entry = 1; entry < motions.count; entry++) {
                motions.data[entry * Motions.STRIDE + Motions.VX] += 1e-5;
            }
            dense.begin();
            if (direct.solveByNewton(H, 0, SETTLED)) {
                found++;
                assertObeys();
            }
        }
        assertThat(found).isGreaterThan(90);
    }

    /** Contacts with the ground that join later are not present yet. */
    @Test
    void whatJoinsLaterCarriesNothing() {
        island.begin(2);
        for (int entry = 1; entry <= 2; entry++) {
            island.body(entry, 1, 1);
            motions.data[entry * Motions.STRIDE + Motions.VY] = -1;
            island.onGround(entry, 0.5, 0.5);
            island.set(entry - 1, PackedContacts.MASS_T, 1);
            island.set(entry - 1, PackedContacts.GIVE, 1e-10);
        }
        contacts.firstSubstep[1] = 3;
        direct.prepare(PLENTY, false, GAINED);
        direct.begin();
        direct.solve(H, 2, SETTLED);
        assertThat(dense.velocities()[4]).isCloseTo(0, within(SOLVED));
        assertThat(dense.velocities()[7]).isEqualTo(-1);
        direct.solve(H, 3, SETTLED);
        assertThat(dense.velocities()[7]).isCloseTo(0, within(SOLVED));
    }

    /** A single point of a single contact is solved by any pass, without elimination. */
    @Test
    void aSinglePointIsLeftToPasses() {
        island.begin(1);
        island.body(1, 1, 0);
        motions.data[Motions.STRIDE + Motions.VY] = -1;
        int row = island.onGround(1, 0.5, 0.5);
        island.set(row, PackedContacts.MASS_T, 1);
        direct.prepare(PLENTY, false, GAINED);
        direct.begin();
        direct.solve(H, 0, SETTLED);
        assertThat(direct.solveByNewton(H, 0, SETTLED)).isTrue();
        assertThat(dense.velocities()[4]).isEqualTo(-1);
        assertThat(direct.work()).isZero();
    }

    /** A budget of 0 ends at once, and the present state stays valid. */
    @Test
    void budgetsAreKept() {
        SplittableRandom random = new SplittableRandom(5);
        heap(random, 10, 0);
        assertThat(direct.prepare(PLENTY, false, GAINED)).isTrue();
        direct.begin();
        direct.solve(H, 0, SETTLED);
        double work = direct.work();
        assertThat(work).isPositive();
        assertThat(direct.prepare(1, false, GAINED)).isFalse();
        heap(random, 10, 0);
        direct.prepare(1, false, GAINED);
        direct.begin();
        assertThat(direct.isSpent()).isFalse();
        assertThat(direct.work()).isZero();
        dense.begin();
        direct.solve(H, 0, SETTLED);
        assertThat(direct.isSpent()).isTrue();
        assertThat(direct.work()).isLessThan(work);
        dense.assertImpulsesTellAll(SOLVED);
    }

    @Test
    void crowdsAreNotSolvedWhole() {
        SplittableRandom random = new SplittableRandom(6);
        island.bodies(random, 65);
        for (int entry = 1; entry <= 64; entry++) {
            contact(random, entry - 1, entry, 0);
        }
        assertThat(direct.prepare(PLENTY, false, GAINED)).isTrue();
        contact(random, 64, 65, 0);
        assertThat(direct.prepare(PLENTY, false, GAINED)).isFalse();
    }

    private void overlaps(SplittableRandom random, int count, double deepest) {
        bodies.smallestWidth[0] = 1;
        heap(random, count, 0);
        for (int row = 0; row < contacts.count; row++) {
            contacts.points[row] = 1;
            island.set(row, PackedContacts.GIVE, 1e-13);
            island.set(row, PackedContacts.RECOVERY, Recovery.RATE);
            island.set(row, PackedContacts.GAP0, random.nextDouble(-deepest, deepest / 5));
            island.set(row, PackedContacts.GAP1, 0);
            island.set(row, PackedContacts.IMPULSE0, 0);
        }
        contacts.groundStart = contacts.count;
        overlap.prepare(false);
        direct.prepare(PLENTY, false, GAINED);
        direct.begin();
    }

    /** Without loads, overlaps open at once by the wanted amounts. */
    @Test
    void overlapOpensAsItIsToOpen() {
        SplittableRandom random = new SplittableRandom(7);
        int parted = 0;
        for (int i = 0; i < 100; i++) {
            overlaps(random, 2 + random.nextInt(4), 1e-3);
            double[] wanted = new double[contacts.count];
            double most = 0;
            for (int row = 0; row < contacts.count; row++) {
                wanted[row] = overlap.wanted(row, 0, H);
                most = Math.max(most, wanted[row]);
            }
            double[] before = dense.velocities();
            direct.correct(H, 0);
            if (farthest() < Recovery.MOST_PUSH * H * 0.99) {
                for (int row = 0; row < contacts.count; row++) {
                    if (wanted[row] > 0) {
                        parted++;
                        assertThat(dense.along(row, 0, dense.displacements()))
                                .isCloseTo(wanted[row], within(yields(wanted[row], most)));
                    }
                }
            }
            assertThat(dense.velocities()).isEqualTo(before);
        }
        assertThat(parted).isGreaterThan(100);
    }

    /**
     * Distance in m by which a row yields that should open by {@code wanted} m, beside others that
     * should open by up to {@code most}. Light bodies below heavy ones are pushed up to 50 times as
     * hard, and a row with little overlap is softer.
     */
    private static double yields(double wanted, double most) {
        double soft = HeldOverlap.FADES * GAINED * H / wanted;
        return 50 * most * (HeldOverlap.COMPLIANCE + soft * soft);
    }

    private double farthest() {
        double most = 0;
        double[] places = dense.displacements();
        for (int i = 3; i < places.length; i++) {
            most = i % 3 == 2 ? most : Math.max(most, Math.abs(places[i]));
        }
        return most;
    }

    /** No body moves faster than three widths a second. */
    @Test
    void waysAreLimited() {
        SplittableRandom random = new SplittableRandom(8);
        int limited = 0;
        double most = Recovery.MOST_PUSH * H;
        for (int i = 0; i < 100; i++) {
            overlaps(random, 2 + random.nextInt(4), 1);
            direct.correct(H, 0);
            assertThat(farthest()).isLessThan(most * (1 + 1e-12));
            limited += farthest() > most * (1 - 1e-12) ? 1 : 0;
        }
        assertThat(limited).isGreaterThan(20);
    }

    /** A body that stands on the ground does not yield to the one above. */
    @Test
    void whatStandsOnTheGroundStays() {
        island.begin(2);
        island.body(1, 1, 1);
        island.body(2, 1, 1);
        island.contact(1, 2, 0.5, 0.5);
        island.onGround(1, 0.5, 0.5);
        for (int row = 0; row < 2; row++) {
            island.set(row, PackedContacts.MASS_T, 1);
            island.set(row, PackedContacts.GIVE, 1e-12);
            island.set(row, PackedContacts.RECOVERY, Recovery.RATE);
        }
        contacts.groundStart = 1;
        island.set(0, PackedContacts.GAP0, -1e-3);
        island.set(0, PackedContacts.GAP1, -1e-3);
        overlap.prepare(false);
        direct.prepare(PLENTY, false, GAINED);
        direct.begin();
        double wanted = overlap.wanted(0, 0, H);
        direct.correct(H, 0);
        double yields = yields(wanted, wanted);
        assertThat(dense.displacements()[4]).isCloseTo(0, within(yields));
        assertThat(dense.displacements()[7]).isCloseTo(wanted, within(yields));
        // Lifted by more than the kept overlap, it takes half of the way.
        island.motions.data[Motions.STRIDE + Motions.DY] = 0;
        island.motions.data[2 * Motions.STRIDE + Motions.DY] = 0;
        island.set(1, PackedContacts.GAP0, 2e-5);
        island.set(1, PackedContacts.GAP1, 2e-5);
        direct.forget();
        direct.correct(H, 0);
        assertThat(dense.displacements()[4]).isCloseTo(-wanted / 2, within(yields));
        assertThat(dense.displacements()[7]).isCloseTo(wanted / 2, within(yields));
    }
}
