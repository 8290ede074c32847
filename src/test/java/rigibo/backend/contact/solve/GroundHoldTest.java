package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;

import java.util.SplittableRandom;

/** Bodies that neighbours pushed into the ground. */
class GroundHoldTest {

    private static final double ROUND_OFF = 1e-13;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final GroundHold ground = new GroundHold(motions, contacts);

    private void gap(int row, double gap) {
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] = gap;
    }

    private void move(SplittableRandom random, int entry) {
        for (int column = Motions.DX; column <= Motions.TURN; column++) {
            motions.data[entry * Motions.STRIDE + column] = random.nextDouble(-0.1, 0.1);
        }
    }

    /** Back to the former overlap, or to none if there was a gap; never pulled. */
    @Test
    void whatWentDeeperComesBack() {
        SplittableRandom random = new SplittableRandom(1);
        int held = 0;
        for (int i = 0; i < 500; i++) {
            island.bodies(random, 2);
            int row = i % 2 == 0 ? island.contact(random, 0, 1) : island.contact(random, 1, 0);
            contacts.points[row] = 1;
            double before = random.nextDouble(-0.1, 0.1);
            gap(row, before);
            ground.begin();
            move(random, 1);
            move(random, 2);
            double[] places = dense.displacements();
            double deep = before + dense.along(row, 0, places);
            ground.hold(0);
            double[] now = dense.displacements();
            double gap = before + dense.along(row, 0, now);
            double least = Math.min(0, before);
            assertThat(gap).isCloseTo(Math.max(deep, least), within(ROUND_OFF));
            double[] push = new double[DenseRows.KINDS];
            push[0] = Math.max(0, least - deep) / dense.response(row, 0, row, 0);
            double[] change = dense.change(push);
            for (int k = 3; k < now.length; k++) {
                assertThat(now[k] - places[k]).isCloseTo(change[k], within(ROUND_OFF));
            }
            held += deep < least ? 1 : 0;
        }
        assertThat(held).isBetween(150, 350);
    }

    /** Two points, one after the other, four times. */
    @Test
    void bothPointsComeBack() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 200; i++) {
            island.bodies(random, 1);
            int row = island.contact(random, 0, 1);
            int at = row * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.LEVER_B0] = -0.6;
            contacts.data[at + PackedContacts.LEVER_B1] = 0.7;
            // Large inertia: moving one point moves the other one by about as much.
            island.body(1, 1, 1e-3);
            island.writeMasses(row);
            ground.begin();
            motions.data[Motions.STRIDE + Motions.DX] = -0.1 * contacts.data[at];
            motions.data[Motions.STRIDE + Motions.DY] = -0.1 * contacts.data[at + 1];
            ground.hold(0);
            for (int point = 0; point < 2; point++) {
                double gap = motions.gap(contacts, row, point);
                assertThat(gap).isBetween(-1e-3, 1e-3);
            }
        }
    }

    /** Only contacts with the ground that are present; one that should come out is held higher. */
    @Test
    void onlyTheGroundHolds() {
        island.begin(2);
        island.body(1, 1, 1);
        island.body(2, 1, 1);
        int above = island.contact(1, 2, 0.5, 0.5);
        int below = island.onGround(1, 0.5, 0.5);
        contacts.points[above] = 1;
        contacts.points[below] = 1;
        contacts.data[below * PackedContacts.STRIDE + PackedContacts.LEVER_B0] = 0;
        contacts.data[below * PackedContacts.STRIDE + PackedContacts.K00] = 1;
        contacts.groundStart = 1;
        contacts.firstSubstep[below] = 2;
        ground.begin();
        motions.data[Motions.STRIDE + Motions.DY] = -0.1;
        motions.data[2 * Motions.STRIDE + Motions.DY] = -0.3;
        ground.hold(1);
        assertThat(dense.displacements()[4]).isEqualTo(-0.1);
        ground.open(below, 0, 0.02);
        ground.hold(2);
        assertThat(dense.displacements()[4]).isCloseTo(0.02, within(ROUND_OFF));
        assertThat(dense.displacements()[7]).isEqualTo(-0.3);
    }
}
