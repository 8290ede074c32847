package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.SplittableRandom;

/** Few voices, the loudest kept, and never too loud together. */
class VoicesTest {

    private static final double TURN = 1.0 / 60;

    private final Sample sample = Sample.of(List.of(Tone.steady(440, 1, 0.1)), 0);

    @Test
    void theQuietestGivesWayToALouderOne() {
        Voices voices = new Voices(3, 1);
        int soft = voices.start(sample, 0.1, 1);
        voices.start(sample, 0.2, 1);
        voices.start(sample, 0.3, 1);
        assertThat(voices.start(sample, 0.15, 1)).isEqualTo(soft);
        assertThat(voices.gain(soft)).isCloseTo(0.15, within(1e-12));
    }

    @Test
    void aQuieterOneThanAllOthersIsNotPlayed() {
        Voices voices = new Voices(2, 1);
        voices.start(sample, 0.2, 1);
        voices.start(sample, 0.3, 1);
        assertThat(voices.start(sample, 0.1, 1)).isEqualTo(Voices.NONE);
    }

    @Test
    void aVoiceThatHasPlayedOutIsFreeAgain() {
        Voices voices = new Voices(1, 1);
        voices.start(sample, 1, 1);
        assertThat(voices.start(sample, 0.01, 1)).isEqualTo(Voices.NONE);
        // The sample is over after seven decays of 0.1 s.
        voices.advance(0.71);
        assertThat(voices.loudness()).isZero();
        assertThat(voices.start(sample, 0.01, 1)).isZero();
    }

    @Test
    void whatIsPlayedTwiceAsFastIsOverInHalfTheTime() {
        Voices voices = new Voices(1, 1);
        voices.start(sample, 1, 2);
        voices.advance(0.36);
        assertThat(voices.loudness()).isZero();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void togetherTheyNeverExceedTheirMost(long seed) {
        double most = 0.5;
        Voices voices = new Voices(12, most);
        SplittableRandom random = new SplittableRandom(seed);
        for (int turn = 0; turn < 600; turn++) {
            for (int i = 0; i < 4; i++) {
                voices.start(sample, random.nextDouble(), 0.5 + random.nextDouble());
            }
            assertThat(voices.loudness()).as("seed %d, turn %d", seed, turn).isBetween(0.0, most);
            voices.advance(TURN);
        }
    }
}
