package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Rolling bodies are heard while they roll. */
class RollingTest {

    private final Rolling rolling = new Rolling();

    private void turns(int count, double speed) {
        for (int i = 0; i < count; i++) {
            rolling.tell(speed);
            rolling.turn();
        }
    }

    @Test
    void isLouderAndHigherTheFasterItRolls() {
        turns(60, 1);
        double slowGain = rolling.gain();
        double slowPitch = rolling.pitch();
        turns(60, 3);
        assertThat(rolling.gain()).isGreaterThan(2 * slowGain);
        assertThat(rolling.pitch()).isGreaterThan(slowPitch);
    }

    @Test
    void isNeverLouderThanItsMost() {
        turns(600, 1000);
        assertThat(rolling.gain()).isBetween(0.99 * Rolling.MOST, Rolling.MOST);
    }

    /** A fifth of the way each turn: after half a second 0.8³⁰ = 0.1 % are left. */
    @Test
    void fallsSilentWhenNothingIsToldAnyMore() {
        turns(60, 5);
        double before = rolling.gain();
        for (int i = 0; i < 30; i++) {
            rolling.turn();
        }
        assertThat(rolling.gain()).isLessThan(0.002 * before);
    }
}
