package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class EarlierImpulsesTest {

    private static final int[] IMPULSES = {
        PackedContacts.IMPULSE0,
        PackedContacts.IMPULSE1,
        PackedContacts.IMPULSE_T,
        PackedContacts.IMPULSE_R
    };

    private final PackedIsland island = new PackedIsland();
    private final EarlierImpulses earlier = new EarlierImpulses(island.contacts);

    /** More contacts than the first capacity, each with another impulse. */
    @Test
    void whatWasPutAsideIsAddedToWhatCameSince() {
        island.begin(1);
        island.body(1, 1, 1);
        for (int i = 0; i < 40; i++) {
            island.onGround(1, 1, 1);
        }
        addToAll(1);
        earlier.putAside();
        for (int row = 0; row < island.contacts.count; row++) {
            for (int column : IMPULSES) {
                assertThat(impulse(row, column)).isZero();
            }
        }
        addToAll(1000);
        earlier.addBack();
        for (int row = 0; row < island.contacts.count; row++) {
            for (int column : IMPULSES) {
                assertThat(impulse(row, column)).isEqualTo(1001.0 * (row + 100 * column));
            }
        }
    }

    private void addToAll(double times) {
        for (int row = 0; row < island.contacts.count; row++) {
            for (int column : IMPULSES) {
                island.contacts.data[row * PackedContacts.STRIDE + column] +=
                        times * (row + 100 * column);
            }
        }
    }

    private double impulse(int row, int column) {
        return island.contacts.data[row * PackedContacts.STRIDE + column];
    }
}
