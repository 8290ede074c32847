package rigibo.frontend.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;

class WordsTest {

    @Test
    void everyLanguageHasEveryKey() {
        ResourceBundle all = ResourceBundle.getBundle("rigibo.words", Locale.ROOT);
        Set<String> keys = new TreeSet<>(all.keySet());
        for (String language : Settings.LANGUAGES) {
            if (!language.equals("en")) {
                // The bundle's own keys: what is missing is looked up in its parent.
                assertThat(ownKeys(language)).containsExactlyInAnyOrderElementsOf(keys);
            }
        }
    }

    private static Set<String> ownKeys(String language) {
        Properties own = new Properties();
        String file =
                "/rigibo/words" + (language.equals("en") ? "" : "_" + language) + ".properties";
        try (var in =
                new InputStreamReader(
                        WordsTest.class.getResourceAsStream(file), StandardCharsets.UTF_8)) {
            own.load(in);
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
        return own.stringPropertyNames();
    }

    @Test
    void speaksTheLanguageAskedForWhateverTheSystemSpeaks() {
        assertThat(new Words("de").of("puzzle.won")).isEqualTo("Gelöst!");
        assertThat(new Words("en").of("puzzle.won")).isEqualTo("Solved!");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void textsNameTheKeysThatWereChosen(String language) {
        Settings settings = Settings.initial(language);
        KeyBindings chosen = settings.keys().with(Action.RESTART, Key.X).orElseThrow();
        Words words = new Words(settings.withKeys(chosen));
        assertThat(words.of("puzzle.key.restart")).isEqualTo("X");
        assertThat(words.of("help.key.6")).isEqualTo("X");
        for (Key key : KeyBindings.FREE) {
            assertThat(words.of(key)).isNotBlank();
        }
        for (String key : ownKeys(language)) {
            assertThat(words.of(key)).as(key).doesNotContainPattern("<[a-z]+>");
        }
    }

    /** The second of two lines would win without a word. */
    @ParameterizedTest
    @ValueSource(strings = {"/rigibo/words.properties", "/rigibo/words_de.properties"})
    void noKeyIsWrittenTwice(String file) throws IOException {
        try (InputStream in = WordsTest.class.getResourceAsStream(file)) {
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            List<String> keys =
                    text.lines()
                            .filter(line -> line.contains("=") && !line.startsWith("#"))
                            .map(line -> line.substring(0, line.indexOf('=')))
                            .toList();
            assertThat(keys).isNotEmpty().doesNotHaveDuplicates();
        }
    }
}
