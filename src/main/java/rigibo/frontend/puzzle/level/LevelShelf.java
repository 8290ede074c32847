package rigibo.frontend.puzzle.level;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The level files of the game, and the meaning of their names. */
public final class LevelShelf {

    /** The world's number, from 1, and the level's within it. */
    private static final Pattern NUMBERED = Pattern.compile("([1-9])-(\\d\\d)-.+\\.json");

    private static final String ENDING = ".json";

    /** The schema of level files, a resource of the class path. */
    static final String SCHEMA = "/levels/level.schema.json";

    private LevelShelf() {}

    /** The files {@code W-NN-name.json}, world by world, in the order of their numbers. */
    public static List<Path> files() {
        return filesIn(LevelFolder.of(SCHEMA));
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

    /** The level files of a player's folder by name; none if there is no such folder. */
    public static List<Path> own(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(file -> name(file).endsWith(ENDING)).sorted().toList();
        } catch (IOException broken) {
            throw new UncheckedIOException("cannot list the levels in " + folder, broken);
        }
    }

    /**
     * The number of the world of a level of the game, from 1.
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

    /** The place in its world of a level of the game, from 1; empty for other files. */
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
