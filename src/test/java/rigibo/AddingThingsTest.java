package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Every file and class named in CONTRIBUTING's table "Adding things" exists. */
class AddingThingsTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    /** Where the table names rooms of the game from. */
    private static final Path ROOMS = HOME.resolve("src/main/java/rigibo");

    private static final Pattern QUOTED = Pattern.compile("`([^`]+)`");

    /** A class, perhaps with a member or a class within it. */
    private static final Pattern CLASS = Pattern.compile("([A-Z][A-Za-z]+)(?:\\.([A-Za-z]+))?");

    /** The name of what is added, which is not there yet: an X, a number, or a place for tests. */
    private static final Pattern ADDED = Pattern.compile("X|X[A-Z].*|X\\..*|x|.*N-name.*|….*");

    static Stream<String> rows() throws IOException {
        return Files.readString(HOME.resolve("CONTRIBUTING.md"))
                .lines()
                .dropWhile(line -> !line.startsWith("| to add"))
                .skip(2)
                .takeWhile(line -> line.startsWith("|"));
    }

    @ParameterizedTest
    @MethodSource("rows")
    void everyFileAndClassIsThere(String row) throws IOException {
        String[] columns = row.split("\\|");
        assertThat(columns).as("what, write, touch").hasSize(4);
        Matcher quoted = QUOTED.matcher(columns[2] + columns[3]);
        while (quoted.find()) {
            requireThere(quoted.group(1));
        }
    }

    private static void requireThere(String named) throws IOException {
        Matcher type = CLASS.matcher(named);
        if (named.startsWith("./rigibo ")) {
            return;
        }
        if (named.contains("/")) {
            requirePath(named);
        } else if (named.endsWith(".properties")) {
            assertThat(files(named)).as(named).isNotEmpty();
        } else if (type.matches() && !ADDED.matcher(named).matches()) {
            requireClass(type);
        }
    }

    /** As far as it is there already: the folder of what is added. */
    private static void requirePath(String named) {
        boolean isRooted = Files.exists(HOME.resolve(named.substring(0, named.indexOf('/'))));
        Path there = isRooted ? HOME : ROOMS;
        for (String part : named.split("/")) {
            if (ADDED.matcher(part).matches()) {
                break;
            }
            there = there.resolve(part);
        }
        assertThat(there).exists();
    }

    private static void requireClass(Matcher type) throws IOException {
        List<Path> found = files(type.group(1) + ".java");
        assertThat(found).as(type.group()).isNotEmpty();
        if (type.group(2) != null) {
            boolean isSaid = false;
            for (Path file : found) {
                isSaid |= Files.readString(file).matches("(?s).*\\b" + type.group(2) + "\\b.*");
            }
            assertThat(isSaid).as(type.group()).isTrue();
        }
    }

    private static List<Path> files(String name) throws IOException {
        try (Stream<Path> files = Files.walk(HOME.resolve("src"))) {
            return files.filter(file -> file.getFileName().toString().equals(name)).toList();
        }
    }
}
