package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Music has a volume of its own. */
class MusicTest {

    private final Samples samples = new Samples();

    /** Gains of the notes of a minute. */
    private List<Double> minute(double volume) {
        Music music = new Music(new Score(1), samples);
        List<Double> gains = new ArrayList<>();
        for (int turn = 0; turn < 3600; turn++) {
            music.advance(1.0 / 60, volume, (voice, sample, gain, pitch) -> gains.add(gain));
        }
        return gains;
    }

    @Test
    void aThirdOfItsVolumeMakesEveryNoteAThirdAsLoud() {
        List<Double> full = minute(1);
        List<Double> third = minute(1.0 / 3);
        assertThat(third).hasSameSizeAs(full).hasSizeGreaterThan(60);
        for (int i = 0; i < full.size(); i++) {
            assertThat(third.get(i)).as("note %d", i).isCloseTo(full.get(i) / 3, within(1e-12));
        }
    }
}
