package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.DenseRows;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;

import java.util.SplittableRandom;

/** More bodies and contacts than the first capacity, whose state changes randomly. */
class HalfwayTest {

    private static final int COUNT = 40;

    private final PackedIsland island = new PackedIsland();
    private final DenseRows dense = new DenseRows(island);
    private final Halfway halfway = new Halfway(island.motions, island.contacts);
    private double[] velocities;
    private double[] impulses;

    private void change(SplittableRandom random) {
        for (int entry = 0; entry <= COUNT; entry++) {
            for (int column = Motions.VX; column <= Motions.TURN; column++) {
                island.motions.data[entry * Motions.STRIDE + column] += random.nextDouble(-1, 1);
            }
        }
        for (int row = 0; row < COUNT; row++) {
            int at = row * PackedContacts.STRIDE;
            for (int column :
                    new int[] {
                        PackedContacts.IMPULSE0,
                        PackedContacts.IMPULSE1,
                        PackedContacts.IMPULSE_T,
                        PackedContacts.IMPULSE_R
                    }) {
                island.contacts.data[at + column] += random.nextDouble(-1, 1);
            }
        }
    }

    private void begin(SplittableRandom random) {
        island.bodies(random, COUNT);
        for (int entry = 1; entry <= COUNT; entry++) {
            island.contact(random, entry - 1, entry);
        }
        change(random);
        velocities = dense.velocities();
        impulses = dense.impulses();
        halfway.begin();
    }

    @Test
    void halfOfARoundIsUndone() {
        SplittableRandom random = new SplittableRandom(1);
        begin(random);
        change(random);
        double[] velocitiesThen = dense.velocities();
        double[] impulsesThen = dense.impulses();
        double[] places = dense.displacements();
        halfway.end();
        for (int i = 0; i < impulses.length; i++) {
            double mean = (impulses[i] + impulsesThen[i]) / 2;
            assertThat(dense.impulses()[i]).isCloseTo(mean, within(1e-15));
        }
        for (int i = 3; i < velocities.length; i++) {
            double mean = (velocities[i] + velocitiesThen[i]) / 2;
            assertThat(dense.velocities()[i]).isCloseTo(mean, within(1e-15));
        }
        assertThat(dense.displacements()).isEqualTo(places);
    }

    @Test
    void allOfARoundIsTakenBack() {
        SplittableRandom random = new SplittableRandom(2);
        begin(random);
        double[] places = dense.displacements();
        change(random);
        halfway.takeBack();
        assertThat(dense.velocities()).isEqualTo(velocities);
        assertThat(dense.impulses()).isEqualTo(impulses);
        assertThat(dense.displacements()).isEqualTo(places);
    }
}
