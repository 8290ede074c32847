package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Skin;

/** Large things sound low, hard blows sound loud. */
class KnockTest {

    /** Pitch goes by the root of size: four times as wide is an octave lower. */
    @Test
    void aBodyFourTimesAsWideSoundsAnOctaveLower() {
        double small = Knock.of(Skin.WOOD, 0.5, 100).pitch();
        double large = Knock.of(Skin.WOOD, 2, 100).pitch();
        assertThat(large).isCloseTo(small / 2, within(1e-12));
        assertThat(Knock.of(Skin.WOOD, 1, 100).pitch()).isCloseTo(1, within(1e-12));
    }

    @Test
    void tenTimesTheImpulseIsSevenDecibelsMore() {
        double soft = Knock.of(Skin.IRON, 1, 10).gain();
        double hard = Knock.of(Skin.IRON, 1, 100).gain();
        assertThat(20 * Math.log10(hard / soft)).isCloseTo(7, within(1e-9));
    }

    @Test
    void noBlowIsLouderThanFullAndNoBodyBeyondTheSamplesReach() {
        Knock huge = Knock.of(Skin.STONE, 1e6, 1e12);
        Knock tiny = Knock.of(Skin.STONE, 1e-6, 1e-12);
        assertThat(huge.gain()).isEqualTo(1);
        assertThat(huge.pitch()).isEqualTo(0.4);
        assertThat(tiny.gain()).isBetween(0.0, 1e-3);
        assertThat(tiny.pitch()).isEqualTo(3);
    }
}
