package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The pages name only files and classes that exist. */
class PagesTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    /** A class with its room, as in {@code contact.row.Kick}. */
    private static final Pattern CLASS = Pattern.compile("`((?:[a-z]+\\.)+[A-Z][A-Za-z]+)");

    private static final Pattern LINK = Pattern.compile("]\\((?!http)([^)#]+)");

    /** A decision that was taken back may name what is there no longer. */
    private static final String TAKEN_BACK = "\nNo longer so";

    private static List<Path> files(Path directory, String ending) throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            return files.filter(file -> file.toString().endsWith(ending)).toList();
        }
    }

    private static List<Path> pages() throws IOException {
        List<Path> pages = new ArrayList<>(files(HOME.resolve("docs"), ".md"));
        pages.add(HOME.resolve("README.md"));
        pages.add(HOME.resolve("CONTRIBUTING.md"));
        return pages;
    }

    private static List<String> found(Pattern pattern, String text) {
        return pattern.matcher(text).results().map(found -> found.group(1)).toList();
    }

    /** A name with all rooms, and with ever fewer of them. */
    private static Set<String> names() throws IOException {
        Set<String> names = new HashSet<>();
        Path source = HOME.resolve("src");
        for (Path file : files(source, ".java")) {
            // Below src/main/java and the like.
            Path inside = source.relativize(file);
            List<String> words = new ArrayList<>();
            inside.subpath(2, inside.getNameCount()).forEach(word -> words.add(word.toString()));
            for (int first = 0; first < words.size(); first++) {
                String name = String.join(".", words.subList(first, words.size()));
                names.add(name.replaceAll("\\.java$", ""));
            }
        }
        return names;
    }

    @Test
    void everyClassNamedWithItsRoomIsThere() throws IOException {
        Set<String> names = names();
        assertThat(names).contains("backend.Pool", "Pool", "rigibo.Main");
        for (Path page : pages()) {
            String text = Files.readString(page);
            if (!text.contains(TAKEN_BACK)) {
                List<String> named = new ArrayList<>(found(CLASS, text));
                named.removeIf(name -> name.startsWith("java."));
                assertThat(names).as("named in %s", page).containsAll(named);
            }
        }
    }

    @Test
    void everyLinkLeadsToAFile() throws IOException {
        for (Path page : pages()) {
            for (String link : found(LINK, Files.readString(page))) {
                assertThat(page.resolveSibling(link)).as("linked in %s", page).exists();
            }
        }
    }
}
