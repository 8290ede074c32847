package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedIsland;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** The order of elimination, compared with its promises for each contact. */
class ContactOrderTest {

    private final PackedIsland island = new PackedIsland();
    private final ContactOrder order = new ContactOrder(island.motions, island.contacts);

    private void bodies(int count) {
        island.begin(count);
        for (int body = 1; body <= count; body++) {
            island.body(body, 1, 1);
        }
    }

    private void contact(int a, int b) {
        island.contact(a, b, 0.5, 0.5);
    }

    /** A body that no impulse moves, like a driven one. */
    private void hold(int body) {
        island.motions.data[body * Motions.STRIDE + Motions.INVERSE_MASS] = 0;
        island.motions.data[body * Motions.STRIDE + Motions.INVERSE_INERTIA] = 0;
    }

    /** One body on the ground that carries others, each by a single contact. */
    private void tray(int carried) {
        bodies(carried + 1);
        contact(0, 1);
        for (int body = 2; body <= carried + 1; body++) {
            contact(1, body);
        }
    }

    /** With eight bodies and the ground it has nine contacts, more than an equal body can have. */
    @ParameterizedTest
    @CsvSource({"7, 0", "8, 1", "30, 1"})
    void whatCarriesManyIsAHub(int carried, int hubs) {
        tray(carried);
        order.find();
        assertThat(order.hubCount).isEqualTo(hubs);
        assertThat(order.isHub(Motions.STRIDE)).isEqualTo(hubs > 0);
        assertThat(order.isHub(0)).isFalse();
        assertPromises();
        if (hubs > 0) {
            assertThat(order.beforeHubs).isEqualTo(carried);
            assertThat(order.place[0]).as("the contact with the ground").isEqualTo(carried);
        }
    }

    /** Impulses do not pass through a body that they cannot move. */
    @Test
    void whatIsDrivenIsNoHubAndConnectsNothing() {
        tray(20);
        hold(1);
        order.find();
        assertThat(order.hubCount).isZero();
        assertThat(order.connects(Motions.STRIDE)).isFalse();
        assertThat(order.connects(0)).isFalse();
        assertThat(order.connects(2 * Motions.STRIDE)).isTrue();
        assertPromises();
        // Each carried body couples with itself alone: 3 rows of an envelope of 3.
        assertThat(order.work()).isEqualTo(21 * 3 * 3 * 3 / 2.0);
    }

    /** A body that cannot turn, or cannot be moved, still passes impulses on. */
    @Test
    void halfOfAMassConnects() {
        tray(9);
        island.motions.data[Motions.STRIDE + Motions.INVERSE_MASS] = 0;
        order.find();
        assertThat(order.connects(Motions.STRIDE)).isFalse();
        assertThat(order.isHub(Motions.STRIDE)).isTrue();
    }

    /**
     * Thirty bodies on each of five: four of these become hubs, the fifth couples its own contacts.
     */
    @Test
    void hubsAreFew() {
        bodies(155);
        for (int hub = 1; hub <= 5; hub++) {
            contact(0, hub);
            for (int i = 0; i < 30; i++) {
                contact(hub, 5 + 30 * (hub - 1) + i + 1);
            }
        }
        order.find();
        assertThat(order.hubCount).isEqualTo(ContactOrder.MOST_HUBS);
        assertPromises();
    }

    @Test
    void anyIslandGetsWhatIsPromised() {
        SplittableRandom random = new SplittableRandom(1);
        int[] asked = new int[ContactOrder.MOST_HUBS + 1];
        for (int i = 0; i < 500; i++) {
            int count = 2 + random.nextInt(40);
            bodies(count);
            int popular = 1 + random.nextInt(3);
            int contacts = random.nextInt(63);
            for (int row = 0; row <= contacts; row++) {
                int b = 1 + random.nextInt(count);
                int a = random.nextInt(random.nextBoolean() ? Math.min(popular, b) : b);
                contact(a, b);
            }
            if (random.nextInt(3) == 0) {
                hold(1 + random.nextInt(count));
            }
            order.find();
            asked[order.hubCount]++;
            assertPromises();
        }
        assertThat(asked[0]).isGreaterThan(100);
        assertThat(asked[1]).isGreaterThan(50);
        assertThat(asked[2]).isGreaterThan(5);
    }

    private void assertPromises() {
        int count = island.contacts.count;
        int[] places = Arrays.copyOf(order.place, count);
        assertThat(IntStream.of(places).sorted().toArray())
                .isEqualTo(IntStream.range(0, count).toArray());
        for (int row = 0; row < count; row++) {
            assertThat(order.order[order.place[row]]).isEqualTo(row);
            boolean isConnected =
                    order.connects(island.contacts.bodyA[row])
                            || order.connects(island.contacts.bodyB[row]);
            assertThat(order.place[row] < order.beforeHubs).isEqualTo(isConnected);
        }
        for (int at = 0; at < count; at++) {
            assertThat(order.firstNeighbour[at]).as("place %d", at).isEqualTo(firstNeighbour(at));
        }
    }

    /** By a search of all pairs of contacts. */
    private int firstNeighbour(int at) {
        if (at >= order.beforeHubs) {
            return order.hubCount > 0 ? order.beforeHubs : at;
        }
        return IntStream.rangeClosed(0, at).filter(other -> share(at, other)).min().orElseThrow();
    }

    private boolean share(int at, int other) {
        int[] a = island.contacts.bodyA;
        int[] b = island.contacts.bodyB;
        int one = order.order[at];
        int two = order.order[other];
        return order.connects(a[one]) && (a[one] == a[two] || a[one] == b[two])
                || order.connects(b[one]) && (b[one] == a[two] || b[one] == b[two]);
    }
}
