package rigibo.frontend.puzzle.level;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystemAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Finds the level files of the game: in the source tree if the game was started from one, so that
 * an author sees edits at once, otherwise beside the schema on the class path.
 */
public final class LevelShelf {

    /** The world's number, from 1, and the level's within it. */
    private static final Pattern NUMBERED = Pattern.compile("([1-9])-(\\d\\d)-.+\\.json");

    /** What level files are held against, among the class path's resources. */
    static final String SCHEMA = "/levels/level.schema.json";

    private LevelShelf() {}

    /** The files {@code W-NN-name.json}, world by world, in the order of their numbers. */
    public static List<Path> files() {
        return filesIn(folder());
    }

    /** The level files of a folder, in the order of their numbers. */
    static List<Path> filesIn(Path folder) {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(file -> NUMBERED.matcher(name(file)).matches())
                    .sorted(Comparator.comparing(LevelShelf::name))
                    .toList();
        } catch (IOException broken) {
            throw new UncheckedIOException("cannot list the levels in " + folder, broken);
        }
    }

    private static Path folder() {
        Path sources = Path.of(System.getProperty("rigibo.home", ""), "levels");
        return Files.exists(sources.resolve("level.schema.json"))
                ? shortened(sources.toAbsolutePath())
                : packaged();
    }

    private static Path packaged() {
        URL schema = LevelShelf.class.getResource(SCHEMA);
        if (schema == null) {
            throw new IllegalStateException(SCHEMA + " is missing");
        }
        try {
            return path(schema.toURI()).getParent();
        } catch (URISyntaxException impossible) {
            throw new IllegalStateException(impossible);
        } catch (IOException broken) {
            throw new UncheckedIOException("cannot open " + schema, broken);
        }
    }

    private static Path path(URI resource) throws IOException {
        if (resource.getScheme().equals("jar")) {
            try {
                // Stays open for the life of the process: its levels are read later.
                FileSystems.newFileSystem(resource, Map.of());
            } catch (FileSystemAlreadyExistsException open) {
                return Path.of(resource);
            }
        }
        return Path.of(resource);
    }

    /** As a user in the working directory would type it, where that is shorter. */
    private static Path shortened(Path folder) {
        Path here = Path.of("").toAbsolutePath();
        return folder.startsWith(here) ? here.relativize(folder) : folder;
    }

    /**
     * The number of the world that a level of the game is in, from 1.
     *
     * @param file one of {@link #files()}
     */
    public static int world(Path file) {
        Matcher matcher = NUMBERED.matcher(name(file));
        if (!matcher.matches()) {
            throw new IllegalArgumentException(
                    "a level of the game must be called W-NN-name.json, was " + name(file));
        }
        return Integer.parseInt(matcher.group(1));
    }

    /** The place in its world of a level of the game, from 1; nothing for other files. */
    public static OptionalInt place(Path file) {
        Matcher matcher = NUMBERED.matcher(name(file));
        return matcher.matches()
                ? OptionalInt.of(Integer.parseInt(matcher.group(2)))
                : OptionalInt.empty();
    }

    private static String name(Path file) {
        return file.getFileName().toString();
    }
}
