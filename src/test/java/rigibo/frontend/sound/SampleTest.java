package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Skin;

import java.util.ArrayList;
import java.util.List;

/** Samples have the pitch, length and loudness that were asked for. */
class SampleTest {

    private static List<Sample> finite() {
        List<Sample> samples = new ArrayList<>();
        for (Skin skin : Skin.values()) {
            samples.add(Timbre.of(skin).sample());
        }
        for (Signal signal : Signal.values()) {
            samples.add(signal.sample());
        }
        for (Instrument instrument : Instrument.values()) {
            samples.add(instrument.sample());
        }
        return samples;
    }

    private static double peak(Sample sample) {
        double most = 0;
        for (short value : sample.values()) {
            most = Math.max(most, Math.abs(value) / (double) Short.MAX_VALUE);
        }
        return most;
    }

    /** The line of a tone that decays in τ is 1/(πτ) wide: 6 Hz here. */
    @ParameterizedTest
    @ValueSource(doubles = {110, 440, 1760})
    void aToneIsWhereItWasAsked(double frequency) {
        Sample sample = Sample.of(List.of(Tone.steady(frequency, 1, 0.05)), 0);
        assertThat(Spectrum.strongest(frequency - 100, frequency + 100, sample))
                .isCloseTo(frequency, within(2.0));
    }

    /** |x(t)| ≤ a·e^(−t/τ), and reaches it once a cycle. */
    @Test
    void aToneDecaysInTheTimeAsked() {
        double decay = 0.1;
        Sample sample = Sample.of(List.of(Tone.steady(1000, 1, decay)), 0);
        double ratio = sample.loudestFrom(0.05 + decay) / sample.loudestFrom(0.05);
        // Looked at by the cycle of 1 ms, a hundredth of the decay.
        assertThat(ratio).isCloseTo(Math.exp(-1), within(0.01));
    }

    /** Long after its start a gliding tone has the frequency it tends to. */
    @Test
    void aGlideGoesWhereItWasAsked() {
        Sample sample = Sample.of(List.of(new Tone(0, 300, 900, 1, 0.2)), 0);
        short[] values = sample.values();
        int crossings = 0;
        int from = (int) (0.8 * Sample.RATE);
        int to = (int) (1.0 * Sample.RATE);
        for (int i = from; i < to; i++) {
            crossings += values[i] < 0 != values[i + 1] < 0 ? 1 : 0;
        }
        // Two a cycle; by then 600·e^(−4…−5) = 11 to 4 Hz are missing.
        assertThat(crossings / 2.0 / 0.2).isCloseTo(900 - 7.0, within(6.0));
    }

    @ParameterizedTest
    @EnumSource(Skin.class)
    void theStrongestPartialOfAKnockIsTheLowest(Skin skin) {
        Timbre timbre = Timbre.of(skin);
        double lowest = timbre.frequency();
        // The line is 1/(πτ) wide, and its neighbours and the hiss lean on it.
        double width = 1 / (Math.PI * timbre.decay());
        assertThat(Spectrum.strongest(20, 10 * lowest, timbre.sample()))
                .isCloseTo(lowest, within(width));
    }

    @Test
    void ironRingsLongerThanWoodAndStone() {
        double later = 0.2;
        double iron = Timbre.of(Skin.IRON).sample().loudestFrom(later);
        assertThat(iron).isGreaterThan(4 * Timbre.of(Skin.WOOD).sample().loudestFrom(later));
        assertThat(iron).isGreaterThan(4 * Timbre.of(Skin.STONE).sample().loudestFrom(later));
    }

    @Test
    void allStartAndEndAtNoughtAndPeakBelowFullScale() {
        assertThat(finite())
                .allSatisfy(
                        sample -> {
                            short[] values = sample.values();
                            assertThat(values[0]).isZero();
                            assertThat(values[values.length - 1]).isZero();
                            assertThat(peak(sample)).isCloseTo(Sample.PEAK, within(1e-4));
                        });
    }

    /** Neither by more from its last value to its first than anywhere between two others. */
    @Test
    void theRumbleComesRoundWithoutAJump() {
        short[] values = Rolling.sample().values();
        int steepest = 0;
        for (int i = 1; i < values.length; i++) {
            steepest = Math.max(steepest, Math.abs(values[i] - values[i - 1]));
        }
        assertThat(Math.abs(values[0] - values[values.length - 1])).isLessThanOrEqualTo(steepest);
        assertThat(peak(Rolling.sample())).isCloseTo(Sample.PEAK, within(1e-4));
    }

    @Test
    void isNeverLouderThanItSaysItWillBe() {
        assertThat(finite())
                .allSatisfy(
                        sample -> {
                            short[] values = sample.values();
                            for (int i = 0; i < values.length; i++) {
                                double said = sample.loudestFrom(i / (double) Sample.RATE);
                                double value = Math.abs(values[i]) / (double) Short.MAX_VALUE;
                                assertThat(value).isLessThanOrEqualTo(said);
                            }
                        });
    }
}
