package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.team.Team;
import rigibo.backend.team.ThreadTeam;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;

@Timeout(60)
class SharedRowsTest {

    /** Number of contacts of each colour; the last two colours have contacts with the ground. */
    private static final int[] SIZES = {300, 250, 40, 1, 200, 90};

    private static final int GROUND = 4;

    private final PackedContacts contacts = new PackedContacts();

    private void pack() {
        contacts.clear(1);
        for (int colour = 0; colour < SIZES.length; colour++) {
            if (colour == GROUND) {
                contacts.groundStart = contacts.count;
                contacts.groundColour = colour;
            }
            for (int i = 0; i < SIZES[colour]; i++) {
                contacts.add();
            }
            contacts.endColour();
        }
    }

    /**
     * A pass visits every contact once, and none before all of the earlier colours. The way back
     * reverses the order, except for contacts with the ground.
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void passesGoFromColourToColour(int workers) {
        pack();
        int[][] orders = {{0, 1, 2, 3, 4, 5}, {3, 2, 1, 0, 4, 5}};
        try (Team team = new ThreadTeam(workers)) {
            SharedRows shared = new SharedRows(team, contacts);
            assertThat(shared.areWorthwhile()).isTrue();
            for (int pass = 0; pass < 200; pass++) {
                int[] order = orders[pass % 2];
                AtomicIntegerArray taken = new AtomicIntegerArray(contacts.count);
                AtomicInteger early = new AtomicInteger();
                shared.pass(
                        pass % 2 == 1,
                        (from, to, worker) -> {
                            for (int row = from; row < to; row++) {
                                early.addAndGet(isEarly(order, taken, row) ? 1 : 0);
                                taken.incrementAndGet(row);
                            }
                        });
                assertThat(early).hasValue(0);
                for (int row = 0; row < contacts.count; row++) {
                    assertThat(taken.get(row)).isOne();
                }
            }
        }
    }

    /** Whether a contact is visited before one of the previous colour. */
    private static boolean isEarly(int[] order, AtomicIntegerArray taken, int row) {
        int at = 0;
        while (colourOf(row) != order[at]) {
            at++;
        }
        boolean isEarly = false;
        for (int other = 0; at > 0 && other < taken.length(); other++) {
            isEarly |= colourOf(other) == order[at - 1] && taken.get(other) == 0;
        }
        return isEarly;
    }

    private static int colourOf(int row) {
        int colour = 0;
        for (int end = SIZES[0]; row >= end; end += SIZES[colour]) {
            colour++;
        }
        return colour;
    }

    @Test
    void oneWorkerDoesAllAtOnce() {
        pack();
        SharedRows alone = new SharedRows(null, contacts);
        assertThat(alone.areWorthwhile()).isFalse();
        assertThat(alone.workers()).isOne();
        int[] asked = new int[3];
        alone.each(
                contacts.count,
                (from, to, worker) -> {
                    asked[0]++;
                    asked[1] += to - from;
                    asked[2] += worker;
                });
        assertThat(asked).containsExactly(1, contacts.count, 0);
    }

    @Test
    void fewContactsAreNotShared() {
        try (Team team = new ThreadTeam(2)) {
            SharedRows shared = new SharedRows(team, contacts);
            contacts.clear(1);
            for (int i = 1; i < SharedRows.WORTHWHILE; i++) {
                contacts.add();
            }
            assertThat(shared.areWorthwhile()).isFalse();
            contacts.add();
            assertThat(shared.areWorthwhile()).isTrue();
            assertThat(team.takeSplits()).isZero();
            shared.each(contacts.count, (from, to, worker) -> {});
            assertThat(team.takeSplits()).isOne();
        }
    }
}
