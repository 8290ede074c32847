package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Code and pages use the field's words; our own few stand in the glossary. */
class WordsTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home"));

    private static final Path GLOSSARY = HOME.resolve("docs/glossary.md");

    /** Wind blows. */
    private static final Set<String> OF_WIND = Set.of("Wind.java", "Gusts.java", "GustForce.java");

    /** As a whole word, and as one of the words of a name in camel case. */
    @ParameterizedTest
    @CsvSource({"blow, impact", "ledger, bodies of a step", "surprise, what was not foreseen"})
    void whatTheFieldHasAWordForIsCalledThat(String retired, String instead) throws IOException {
        String name = Character.toUpperCase(retired.charAt(0)) + retired.substring(1);
        Pattern found = Pattern.compile("\\b" + retired + "s?(?![a-z])|" + name + "s?(?![a-z])");
        for (Path file : engine()) {
            assertThat(found.matcher(Files.readString(file)).find())
                    .as("%s says '%s', which is %s", HOME.relativize(file), retired, instead)
                    .isFalse();
        }
    }

    /** The decisions tell history in the words of their time. */
    @ParameterizedTest
    @CsvSource({
        "a blow, an impact",
        "ledger, a list",
        "surprise, what was not foreseen",
        "in a hand, in a handheld window",
        "on a desk, in a desktop window"
    })
    void pagesDoWithoutRetiredWords(String retired, String instead) throws IOException {
        Pattern found = Pattern.compile("\\b" + retired + "s?\\b", Pattern.CASE_INSENSITIVE);
        for (Path page : pages()) {
            String name = HOME.relativize(page).toString();
            String text = Files.readString(page).replaceAll("\\s+", " ");
            if (!page.equals(GLOSSARY)) {
                assertThat(found.matcher(text).find())
                        .as("%s says '%s', which is %s", name, retired, instead)
                        .isFalse();
            }
        }
    }

    private static List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.walk(HOME.resolve("docs"))) {
            Stream<Path> own = Stream.of("README.md", "CONTRIBUTING.md").map(HOME::resolve);
            return Stream.concat(own, files.filter(file -> file.toString().endsWith(".md")))
                    .filter(file -> !file.startsWith(HOME.resolve("docs/decisions")))
                    .toList();
        }
    }

    @Test
    void theGlossaryIsInOrderAndEveryWordOfItIsUsed() throws IOException {
        List<String> terms =
                Files.readAllLines(GLOSSARY).stream()
                        .map(Pattern.compile("^\\| ([a-z]+) \\| .+")::matcher)
                        .filter(Matcher::matches)
                        .map(matcher -> matcher.group(1))
                        .filter(term -> !term.equals("word"))
                        .toList();
        assertThat(terms).isSorted().doesNotHaveDuplicates().hasSizeGreaterThan(10);
        StringBuilder engine = new StringBuilder();
        for (Path file : engine()) {
            engine.append(Files.readString(file).toLowerCase());
        }
        assertThat(terms).allMatch(term -> engine.indexOf(term) >= 0);
    }

    private static List<Path> engine() throws IOException {
        try (Stream<Path> files = Files.walk(HOME.resolve("src/main/java/rigibo/backend"))) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> !OF_WIND.contains(file.getFileName().toString()))
                    .toList();
        }
    }
}
