package rigibo.frontend.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** The score composed from a seed. */
class ScoreTest {

    /** About ten minutes. */
    private static final int MANY = 2000;

    private static final Set<Long> C_MAJOR = Set.of(0L, 2L, 4L, 5L, 7L, 9L, 11L);

    private static List<Note> notes(long seed) {
        return Stream.generate(new Score(seed)::next).limit(MANY).toList();
    }

    @Test
    void aSeedGivesTheSameNotesAndAnotherOneOthers() {
        assertThat(notes(7)).isEqualTo(notes(7)).isNotEqualTo(notes(8));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, -4, 1_000_000_007})
    void notesComeInTheirOrderOnTheGridAndCalmly(long seed) {
        List<Note> notes = notes(seed);
        for (int i = 1; i < notes.size(); i++) {
            assertThat(notes.get(i).start()).isGreaterThanOrEqualTo(notes.get(i - 1).start());
        }
        double first = notes.get(0).start();
        assertThat(notes)
                .allSatisfy(
                        note -> {
                            double eighths = (note.start() - first) / Score.EIGHTH;
                            assertThat(eighths).isCloseTo(Math.rint(eighths), within(1e-6));
                        });
        double seconds = notes.get(notes.size() - 1).start();
        assertThat(notes.size() / seconds).as("notes a second").isBetween(0.8, 3.5);
    }

    /** Twelve keys are a factor of two, and key 69 is 440 Hz, so that key 60 is a C. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, -4, 1_000_000_007})
    void everyToneIsOfTheScaleAndWithinWhatSmallSpeakersPlay(long seed) {
        assertThat(notes(seed))
                .allSatisfy(
                        note -> {
                            double key = 69 + 12 * Math.log(note.frequency() / 440) / Math.log(2);
                            assertThat(key).isCloseTo(Math.rint(key), within(1e-6));
                            assertThat(C_MAJOR).contains(Math.round(key) % 12);
                            assertThat(note.frequency()).isBetween(80.0, 2000.0);
                            assertThat(note.gain()).isBetween(0.05, 0.7);
                        });
    }
}
