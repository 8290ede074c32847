package rigibo.backend.storage;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SlotsTest {

    @Test
    void lastReturnedIsHandedOutNext() {
        Slots slots = new Slots();
        for (int i = 0; i < 40; i++) {
            assertThat(slots.take()).isEqualTo(i);
        }
        slots.giveBack(7);
        slots.giveBack(30);
        assertThat(slots.inUse()).isEqualTo(38);
        assertThat(slots.occupied()).hasSize(38).doesNotContain(7, 30);
        assertThat(slots.take()).isEqualTo(30);
        assertThat(slots.take()).isEqualTo(7);
        assertThat(slots.take()).isEqualTo(40);
    }

    /** However many there were at once: what was emptied is no larger for it. */
    @Test
    void emptiedSlotsBeginAnew() {
        Slots slots = new Slots();
        for (int i = 0; i < 100; i++) {
            slots.take();
        }
        for (int i = 99; i >= 0; i -= 2) {
            slots.giveBack(i);
        }
        for (int i = 0; i < 100; i += 2) {
            slots.giveBack(i);
        }
        assertThat(slots.high).isZero();
        assertThat(slots.freeCount).isZero();
        assertThat(slots.take()).isZero();
    }
}
