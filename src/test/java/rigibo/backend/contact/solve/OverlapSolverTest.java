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

/** Overlap that is taken back, of bodies that lie on the ground and do not turn. */
class OverlapSolverTest {

    private static final double H = 1.0 / 240;

    /** The most contacts that elimination takes, and one more. */
    private static final int FEW = 64;

    private static final int CROWD = 65;

    private final PackedIsland island = new PackedIsland();
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final Bodies bodies = new Bodies(Effects.of(new Contacts()));

    /** A pass takes back the share 25·h/(1 + 25·h) of what is more than a hundred-thousandth. */
    @Test
    void fewAreMovedApartButForRoundOff() {
        double overlap = 5e-4;
        double left = left(FEW, overlap, Accuracy.GAME);
        double rate = Recovery.RATE * H;
        double kept = Recovery.KEPT_OVERLAP;
        double truth = kept + (overlap - kept) / (1 + rate);
        assertThat(left).isCloseTo(truth, within(1e-15));
    }

    /** Ten times the tolerance of impacts, as finely as that asks for, and a thousandth at most. */
    @Test
    void crowdKeepsWhatDoesNotShow() {
        assertThat(left(CROWD, 0.9e-3, Accuracy.DRAFT)).isEqualTo(0.9e-3);
        assertThat(left(CROWD, 0.9e-3, Accuracy.GAME)).isEqualTo(0.9e-3);
        assertThat(left(CROWD, 1.1e-3, Accuracy.GAME)).isLessThan(1.1e-3).isGreaterThan(1e-3);
        assertThat(left(CROWD, 0.9e-3, Accuracy.EXACT)).isLessThan(0.9e-3);
    }

    /** What one pass leaves of the overlap in m, with so many bodies of a metre on the ground. */
    private double left(int count, double overlap, Accuracy accuracy) {
        island.begin(count);
        for (int body = 1; body <= count; body++) {
            island.body(body, 1, 0);
            int row = island.onGround(body, 0.5, 0.5);
            int at = row * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.RECOVERY] = Recovery.RATE;
            contacts.data[at + PackedContacts.GAP0] = -overlap;
        }
        OverlapSolver solver = new OverlapSolver(bodies, motions, contacts, accuracy);
        solver.prepare();
        solver.correctInPasses(H, 0, 1);
        return overlap - motions.data[Motions.STRIDE + Motions.DY];
    }
}
