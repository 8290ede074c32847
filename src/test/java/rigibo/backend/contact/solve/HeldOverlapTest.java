package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;
import rigibo.backend.contact.row.Recovery;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;

/** How far nearly unloaded rows hold while overlap is removed. */
class HeldOverlapTest {

    private static final double H = 1.0 / 240;

    /** Speed that a free body gains in the step, m/s. */
    private static final double GAINED = 9.81 / 60;

    private final PackedIsland island = new PackedIsland();
    private final PackedContacts contacts = island.contacts;
    private final DenseRows dense = new DenseRows(island);
    private final OverlapSolver overlap =
            new OverlapSolver(
                    new Bodies(Effects.of(new Contacts())),
                    island.motions,
                    contacts,
                    Accuracy.GAME);
    private final DirectSolver direct = new DirectSolver(island.motions, contacts, overlap, 16);

    /** Two overlapping boxes of 1 kg, the lower of which rests on a floor with a load in N·s. */
    private double twoBoxes(double load) {
        island.begin(2);
        island.body(1, 1, 0);
        island.body(2, 1, 0);
        island.contact(1, 2, 0.5, 0.5);
        island.onGround(1, 0.5, 0.5);
        for (int row = 0; row < 2; row++) {
            island.set(row, PackedContacts.MASS_T, 1);
            island.set(row, PackedContacts.RECOVERY, Recovery.RATE);
        }
        contacts.groundStart = 1;
        island.set(0, PackedContacts.GAP0, -1e-3);
        island.set(0, PackedContacts.GAP1, -1e-3);
        // Farther from the floor than a standing body.
        island.set(1, PackedContacts.GAP0, 2e-5);
        island.set(1, PackedContacts.GAP1, 2e-5);
        island.set(1, PackedContacts.IMPULSE0, load);
        overlap.prepare(false);
        assertThat(direct.prepare(1e12, false, GAINED)).isTrue();
        direct.begin();
        double wanted = overlap.wanted(0, 0, H);
        direct.correct(H, 0);
        return wanted;
    }

    /**
     * The floor's row has the compliance ε = (s/v)² of the lower box, which its load gives v and
     * which fades at s. The push p that opens the gap by w, and the floor's push q, obey 2p − q = w
     * and (1 + ε)q = p; the boxes go by q − p and p. From half of the way each, where nothing
     * holds, to the upper one alone.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.02, 0.3, 1, 3, 50, 1e6})
    void whatFadesLetsGoLittleByLittle(double share) {
        double fades = HeldOverlap.FADES * GAINED;
        double wanted = twoBoxes(share * fades);
        double soft = HeldOverlap.COMPLIANCE + 1 / (share * share);
        double held = share == 0 ? 0 : 1 / (1 + soft);
        double push = wanted / (2 - held);
        double rounded = 1e-6 * wanted;
        assertThat(dense.displacements()[4]).isCloseTo((held - 1) * push, within(rounded));
        assertThat(dense.displacements()[7]).isCloseTo(push, within(rounded));
    }
}
