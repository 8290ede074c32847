package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.KeptOverlap;

/** Removal of overlap, for bodies that lie on the ground and do not turn. */
class OverlapSolverTest {

    private static final double H = 1.0 / 240;

    /** The most contacts that elimination takes, and one more. */
    private static final int FEW = 64;

    private static final int CROWD = 65;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final Bodies bodies = new Bodies(Effects.of(new Contacts()));

    /** A pass removes the share 25·h/(1 + 25·h) of the overlap beyond a hundred-thousandth. */
    @Test
    void fewAreMovedApartButForRoundOff() {
        double overlap = 5e-4;
        double left = left(FEW, overlap, Accuracy.GAME);
        double rate = Recovery.RATE * H;
        double kept = KeptOverlap.LEAST;
        double truth = kept + (overlap - kept) / (1 + rate);
        assertThat(left).isCloseTo(truth, within(1e-15));
    }

    /** A small, calm pile loses the last of its overlap at once, so that it can rest. */
    @Test
    void calmFewLoseTheLastAtOnce() {
        double kept = KeptOverlap.LEAST;
        assertThat(left(FEW, 0.9e-3, Accuracy.GAME, true)).isCloseTo(kept, within(1e-15));
        double atFine = left(FEW, 0.9e-3, Accuracy.FINE, true);
        assertThat(atFine).isEqualTo(left(FEW, 0.9e-3, Accuracy.FINE, false));
        double more = kept + (1.1e-3 - kept) / (1 + Recovery.RATE * H);
        assertThat(left(FEW, 1.1e-3, Accuracy.GAME, true)).isCloseTo(more, within(1e-15));
    }

    /** If one point rose at once and the other, a little deeper, did not, the body would turn. */
    @Test
    void bothPointsOfAContactGoAlike() {
        assertThat(opens(1.2e-3, 0.95e-3)).isCloseTo(byShare(0.95e-3), within(1e-15));
        assertThat(opens(0.95e-3, 1.2e-3)).isCloseTo(byShare(1.2e-3), within(1e-15));
        double kept = KeptOverlap.LEAST;
        assertThat(opens(0.9e-3, 0.5e-3)).isCloseTo(0.5e-3 - kept, within(1e-15));
    }

    private static double byShare(double overlap) {
        double rate = Recovery.RATE * H;
        return (overlap - KeptOverlap.LEAST) * rate / (1 + rate);
    }

    /** Distance by which the second of two points should open in a small, calm pile, m. */
    private double opens(double overlap, double overlapOfSecond) {
        island.begin(1);
        island.body(1, 1, 1);
        int row = island.onGround(1, 0.5, 0.5);
        overlap(row, overlap);
        contacts.points[row] = 2;
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP1] = -overlapOfSecond;
        OverlapSolver solver = new OverlapSolver(bodies, motions, contacts, Accuracy.GAME);
        solver.prepare(true);
        return solver.wanted(row, 1, H);
    }

    /** Ten times the tolerance of impacts, which is fine enough; a thousandth at most. */
    @Test
    void crowdKeepsWhatDoesNotShow() {
        assertThat(left(CROWD, 0.9e-3, Accuracy.DRAFT)).isEqualTo(0.9e-3);
        assertThat(left(CROWD, 0.9e-3, Accuracy.GAME)).isEqualTo(0.9e-3);
        assertThat(left(CROWD, 1.1e-3, Accuracy.GAME)).isLessThan(1.1e-3).isGreaterThan(1e-3);
        assertThat(left(CROWD, 0.9e-3, Accuracy.EXACT)).isLessThan(0.9e-3);
    }

    /** Bodies that hardly move could not rest while the last of their overlap is being removed. */
    @Test
    void calmCrowdKeepsTwiceThat() {
        assertThat(left(CROWD, 1.9e-3, Accuracy.GAME, true)).isEqualTo(1.9e-3);
        assertThat(left(CROWD, 2.1e-3, Accuracy.GAME, true)).isLessThan(2.1e-3);
        double few = left(FEW, 1.9e-3, Accuracy.GAME, true);
        assertThat(few).isEqualTo(left(FEW, 1.9e-3, Accuracy.GAME, false)).isLessThan(1.9e-3);
    }

    /** The gap opens by the same amount, whichever body moves. */
    @Test
    void onlyTheUpperOfTwoIsRaisedInACalmCrowd() {
        double shared = parted(true, 0, 0);
        assertThat(moved(1, Motions.DY)).isCloseTo(-shared / 2, within(1e-15));
        assertThat(parted(true, 0, -9.81)).isCloseTo(shared, within(1e-15));
        assertThat(moved(1, Motions.DY)).isCloseTo(0, within(1e-15));
        assertThat(parted(true, 0, 9.81)).isCloseTo(shared, within(1e-15));
        assertThat(moved(2, Motions.DY)).isCloseTo(0, within(1e-15));
    }

    /** By cos²: at half a right angle the lower body moves by half of its share. */
    @Test
    void whatLiesSideBySideSharesTheWay() {
        double shared = parted(true, -9.81, 0);
        assertThat(moved(1, Motions.DY)).isCloseTo(-shared / 2, within(1e-15));
        assertThat(parted(true, 0, 0)).isEqualTo(shared);
        assertThat(moved(1, Motions.DY)).isCloseTo(-shared / 2, within(1e-15));
        assertThat(parted(true, -7, -7)).isCloseTo(shared, within(1e-15));
        assertThat(moved(1, Motions.DY)).isCloseTo(-shared / 4, within(1e-15));
    }

    /** Distance in m by which one pass parts the second body from the first, on which it lies. */
    private double parted(boolean isCalm, double pullX, double pullY) {
        bodies.accelerationX[0] = pullX;
        bodies.accelerationY[0] = pullY;
        island.begin(CROWD);
        island.body(1, 1, 0);
        island.body(2, 1, 0);
        overlap(island.contact(1, 2, 0.5, 0.5), 0.01);
        for (int more = 1; more < CROWD; more++) {
            overlap(island.contact(1, 2, 0.5, 0.5), 0);
        }
        OverlapSolver solver = new OverlapSolver(bodies, motions, contacts, Accuracy.GAME);
        solver.prepare(isCalm);
        solver.correct(H, 0);
        return moved(2, Motions.DY) - moved(1, Motions.DY);
    }

    private void overlap(int row, double overlap) {
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.RECOVERY] = Recovery.RATE;
        contacts.data[row * PackedContacts.STRIDE + PackedContacts.GAP0] = -overlap;
    }

    private double moved(int body, int along) {
        return motions.data[body * Motions.STRIDE + along];
    }

    private double left(int count, double overlap, Accuracy accuracy) {
        return left(count, overlap, accuracy, false);
    }

    /** Overlap in m left by one pass, with a number of bodies of 1 m on the ground. */
    private double left(int count, double overlap, Accuracy accuracy, boolean isCalm) {
        island.begin(count);
        for (int body = 1; body <= count; body++) {
            island.body(body, 1, 0);
            overlap(island.onGround(body, 0.5, 0.5), overlap);
        }
        OverlapSolver solver = new OverlapSolver(bodies, motions, contacts, accuracy);
        solver.prepare(isCalm);
        solver.correctInPasses(H, 0, 1);
        return overlap - moved(1, Motions.DY);
    }
}
