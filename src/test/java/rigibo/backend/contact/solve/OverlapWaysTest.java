package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

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

/**
 * The directions in which overlap of random contacts is removed, compared with their written-out
 * rows.
 */
class OverlapWaysTest {

    private static final double H = 1.0 / 240;
    private static final double ROUND_OFF = 1e-13;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final Bodies bodies = new Bodies(Effects.of(new Contacts(), new Rotation()));
    private final OverlapSolver solver =
            new OverlapSolver(bodies, motions, contacts, Accuracy.GAME);

    @BeforeEach
    void widen() {
        bodies.smallestWidth[0] = 2;
    }

    private void overlap(int row, double first, double second) {
        int at = row * PackedContacts.STRIDE;
        contacts.data[at + PackedContacts.WIDTH] = 2;
        contacts.data[at + PackedContacts.RECOVERY] = 30;
        contacts.data[at + PackedContacts.GAP0] = -first;
        contacts.data[at + PackedContacts.GAP1] = -second;
    }

    /**
     * The share rate·h/(1 + rate·h) of the overlap that is not kept, at most three widths a second.
     */
    private static double wanted(double overlap) {
        double over = Math.max(0, overlap - 2 * KeptOverlap.LEAST);
        return Math.min(over * 30 * H / (1 + 30 * H), Recovery.MOST_PUSH * 2 * H);
    }

    /** The pushes p ≥ 0 that open both points, or the one that must be opened alone. */
    private double[] pushes(int row, double want0, double want1) {
        double k00 = dense.response(row, 0, row, 0);
        double k01 = dense.response(row, 0, row, 1);
        double k11 = dense.response(row, 1, row, 1);
        double determinant = k00 * k11 - k01 * k01;
        double both0 = (k11 * want0 - k01 * want1) / determinant;
        double both1 = (k00 * want1 - k01 * want0) / determinant;
        if (want1 == 0 || both1 < 0) {
            return new double[] {want0 / k00, 0, 0, 0};
        }
        if (want0 == 0 || both0 < 0) {
            return new double[] {0, want1 / k11, 0, 0};
        }
        return new double[] {both0, both1, 0, 0};
    }

    @Test
    void bothPointsOpenAtOnce() {
        SplittableRandom random = new SplittableRandom(1);
        int both = 0;
        for (int i = 0; i < 1_000; i++) {
            island.bodies(random, 2);
            int row = island.contact(random, 1, 2);
            double first = random.nextDouble(-0.02, 0.05);
            double second = random.nextDouble(-0.02, i % 5 == 0 ? 2 : 0.05);
            overlap(row, first, second);
            contacts.firstSubstep[row] = 2;
            solver.prepare(false);
            solver.correct(H, 1);
            assertThat(motions.areWhereTheyWere()).isTrue();
            double[] speeds = dense.velocities();
            solver.correct(H, 2);
            double[] pushes = pushes(row, wanted(first), wanted(second));
            double[] change = dense.change(pushes);
            double[] now = dense.displacements();
            for (int k = 3; k < now.length; k++) {
                assertThat(now[k]).isCloseTo(change[k], within(ROUND_OFF));
            }
            assertThat(dense.velocities()).isEqualTo(speeds);
            both += pushes[0] > 0 && pushes[1] > 0 ? 1 : 0;
        }
        assertThat(both).isGreaterThan(200);
    }

    /** With a single point the other is not read. */
    @Test
    void singlePointsOpenAlone() {
        SplittableRandom random = new SplittableRandom(2);
        island.bodies(random, 2);
        int row = island.contact(random, 1, 2);
        overlap(row, 0.01, 0.05);
        contacts.points[row] = 1;
        solver.prepare(false);
        solver.correct(H, 0);
        double opened = dense.along(row, 0, dense.displacements());
        assertThat(opened).isCloseTo(wanted(0.01), within(ROUND_OFF));
    }

    /**
     * Each of two passes moves at half of the greatest speed, the first from the last contact on.
     */
    @Test
    void passesShareTheHighestSpeed() {
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 1, 0);
        overlap(island.contact(1, 2, 0.5, 0.5), 1.5, 0);
        contacts.groundStart = 1;
        solver.prepare(false);
        solver.correctInPasses(H, 0, 2);
        double opened = dense.along(0, 0, dense.displacements());
        assertThat(opened).isCloseTo(Recovery.MOST_PUSH * 2 * H, within(1e-9));
    }

    /** The middle one of three is pushed from both sides: by the last contact first, then back. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void everySecondPassGoesBack(int passes) {
        island.begin(3);
        for (int entry = 1; entry <= 3; entry++) {
            island.body(entry, 1, 0);
        }
        overlap(island.contact(1, 2, 0.5, 0.5), 0.01, 0);
        overlap(island.contact(2, 3, 0.5, 0.5), 0.01, 0);
        contacts.groundStart = 2;
        solver.prepare(false);
        solver.correctInPasses(H, 0, passes);
        double[] places = new double[3];
        for (int pass = 0; pass < passes; pass++) {
            for (int i = 0; i < 2; i++) {
                int lower = pass % 2 == 0 ? 1 - i : i;
                double opens = wanted(0.01 - (places[lower + 1] - places[lower]));
                places[lower] -= opens / 2;
                places[lower + 1] += opens / 2;
            }
        }
        double[] now = dense.displacements();
        for (int body = 0; body < 3; body++) {
            assertThat(now[3 * body + 4]).isCloseTo(places[body], within(ROUND_OFF));
        }
    }

    /** More than the kept overlap, at either point, of a contact that is present. */
    @ParameterizedTest
    @CsvSource({
        "0.9, 0.9, 2, 0, false",
        "1.1, 0, 2, 0, true",
        "0, 1.1, 2, 0, true",
        "0, 1.1, 1, 0, false",
        "1.1, 0, 1, 0, true",
        "1.1, 1.1, 2, 1, false"
    })
    void onlyMoreThanTheKeptOverlapIsDeep(
            double first, double second, int points, int joins, boolean isDeep) {
        island.begin(1);
        island.body(1, 1, 1);
        int row = island.onGround(1, 0.5, 0.5);
        double kept = 2 * KeptOverlap.LEAST;
        overlap(row, first * kept, second * kept);
        contacts.points[row] = points;
        contacts.firstSubstep[row] = joins;
        solver.prepare(false);
        assertThat(solver.findDeep(0)).isEqualTo(isDeep);
        assertThat(solver.isAnyWanted(0, H, 0)).isEqualTo(isDeep);
        solver.correctInPasses(H, 0, 1);
        assertThat(motions.areWhereTheyWere()).isEqualTo(!isDeep);
    }

    @Test
    void whatIsWantedIsAShareOfTheWidth() {
        island.begin(1);
        island.body(1, 1, 1);
        int row = island.onGround(1, 0.5, 0.5);
        overlap(row, 0, 0.01);
        solver.prepare(false);
        assertThat(solver.wanted(row, 1, H)).isCloseTo(wanted(0.01), within(ROUND_OFF));
        assertThat(solver.wanted(row, 0, H)).isZero();
        double share = wanted(0.01) / 2;
        assertThat(solver.isAnyWanted(0.99 * share, H, 0)).isTrue();
        assertThat(solver.isAnyWanted(1.01 * share, H, 0)).isFalse();
    }

    /** A heavy body overlaps one, which overlaps the ground, by distances in m: one pass. */
    private void pressDown(double above, double below) {
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 1e-3, 0);
        overlap(island.contact(1, 2, 0.5, 0.5), above, 0);
        overlap(island.onGround(1, 0.5, 0.5), below, 0);
        contacts.groundStart = 1;
        solver.prepare(false);
        solver.correctAndHoldGround(H, 0, 1);
    }

    /**
     * A body that two others push into the ground comes back to its place; these keep their rest.
     */
    @Test
    void groundDoesNotYield() {
        pressDown(0.01, 0);
        assertThat(dense.displacements()[4]).isCloseTo(0, within(ROUND_OFF));
        assertThat(dense.displacements()[7]).isPositive();
    }

    /** A body deeper in the ground than a hundredth of its width comes out at its rate. */
    @ParameterizedTest
    @CsvSource({"0.019, false", "0.021, true"})
    void whatIsDeepInTheGroundComesOut(double deep, boolean comesOut) {
        pressDown(0.5, deep);
        double out = comesOut ? wanted(deep) : 0;
        assertThat(dense.displacements()[4]).isCloseTo(out, within(ROUND_OFF));
    }

    /** In space no body moves by more than three widths a second, however many push it. */
    @Test
    void waysAreLimitedInSpace() {
        island.begin(4);
        for (int entry = 1; entry <= 4; entry++) {
            island.body(entry, 1, 0);
        }
        for (int entry = 2; entry <= 4; entry++) {
            overlap(island.contact(1, entry, 0.5, 0.5), 1.5, 0);
        }
        contacts.groundStart = 3;
        solver.prepare(false);
        solver.correctAndHoldGround(H, 0, 1);
        double most = Recovery.MOST_PUSH * 2 * H;
        double[] now = dense.displacements();
        for (int entry = 1; entry <= 4; entry++) {
            assertThat(Math.abs(now[3 * entry + 1])).isLessThan(most * (1 + 1e-12));
        }
        assertThat(now[4]).isNegative();
        assertThat(now[7]).isPositive();
    }
}
