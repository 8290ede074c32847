package rigibo.backend.contact.row;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.setup.Accuracy;

class EffortTest {

    @Test
    void presetsAreInOrder() {
        assertThat(Effort.isThorough(Accuracy.DRAFT)).isFalse();
        assertThat(Effort.isThorough(Accuracy.GAME)).isTrue();
        assertThat(Effort.isExact(Accuracy.FINE)).isFalse();
        assertThat(Effort.isExact(Accuracy.EXACT)).isTrue();
    }

    @Test
    void substepsAloneCount() {
        int ofGame = Accuracy.GAME.substeps();
        assertThat(Effort.timesGame(Accuracy.EXACT.withSubsteps(3 * ofGame))).isEqualTo(3);
        assertThat(Effort.isExact(Accuracy.EXACT.withSubsteps(ofGame))).isFalse();
        assertThat(Effort.isExact(Accuracy.GAME.withSubsteps(Accuracy.EXACT.substeps()))).isTrue();
    }
}
