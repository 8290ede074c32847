package rigibo.frontend.save;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.document.Mutations;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.Settings;

import java.nio.charset.StandardCharsets;

/** A language that was null kept the game from starting. */
class MutatedSaveFilesTest {

    private static final Format<Settings> SETTINGS = new SettingsFormat(Settings.initial("en"));
    private static final Format<Progress> PROGRESS = new ProgressFormat();

    @Test
    void noValueOfAnySettingIsWorseThanADamagedFile() {
        assertReadOrRefused(Settings.initial("de"), SETTINGS);
    }

    @Test
    void noValueOfAnyProgressIsWorseThanADamagedFile() {
        Progress played =
                Progress.none().solved("tilt", -7, 2).failed("tilt", -7).failed("arch", 5);
        assertReadOrRefused(played, PROGRESS);
    }

    private static <T> void assertReadOrRefused(T sound, Format<T> format) {
        String text = new String(Reading.bytes(sound, format), StandardCharsets.UTF_8);
        assertThat(read(text, format).value()).contains(sound);
        Mutations.of(text).forEach(mutated -> assertReadOrRefused(mutated, format));
    }

    private static <T> void assertReadOrRefused(String mutated, Format<T> format) {
        Reading<T> reading = read(mutated, format);
        String shown = mutated.substring(0, Math.min(300, mutated.length()));
        switch (reading.state()) {
            case WHOLE -> assertThat(reading.value()).as(shown).isPresent();
            case DAMAGED, NEWER -> assertThat(reading.problems()).as(shown).isNotEmpty();
            case MISSING, UNREADABLE -> throw new AssertionError(reading.state() + ": " + shown);
        }
    }

    private static <T> Reading<T> read(String text, Format<T> format) {
        return Reading.parse("a.json", text.getBytes(StandardCharsets.UTF_8), format);
    }

    @Test
    void aFailureMoreThanCanBeCountedIsNotCounted() {
        String text =
                """
                {"format": 1, "levels": {"tilt": {"hash": "7", "solved": false,
                 "failures": 2147483647}}}
                """;
        Progress progress = read(text, PROGRESS).value().orElseThrow();
        assertThat(progress.failed("tilt", 7).of("tilt", 7).failures()).isEqualTo(2147483647);
    }
}
