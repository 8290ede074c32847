package rigibo.frontend.puzzle.level;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystem;
import java.nio.file.FileSystemAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Finds the level files that come with the game, beside the schema on the class path. */
public final class LevelShelf {

    private static final Pattern NUMBERED = Pattern.compile("(\\d{1,9}).*\\.json");
    private static final Comparator<Path> BY_NUMBER =
            Comparator.comparingInt(LevelShelf::number).thenComparing(LevelShelf::name);

    private LevelShelf() {}

    /** The files {@code NN-name.json}, in the order of their numbers. */
    public static List<Path> files() {
        return filesIn(folder());
    }

    /** The level files of a folder, in the order of their numbers. */
    static List<Path> filesIn(Path folder) {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(file -> NUMBERED.matcher(name(file)).matches())
                    .sorted(BY_NUMBER)
                    .toList();
        } catch (IOException broken) {
            throw new UncheckedIOException("cannot list the levels in " + folder, broken);
        }
    }

    private static Path folder() {
        URL schema = LevelShelf.class.getResource(LevelSchema.RESOURCE);
        if (schema == null) {
            throw new IllegalStateException(LevelSchema.RESOURCE + " is missing");
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
            openJar(resource);
        }
        return Path.of(resource);
    }

    /** A jar's file system stays open for the life of the process: its levels are read later. */
    private static void openJar(URI resource) throws IOException {
        try {
            FileSystem opened = FileSystems.newFileSystem(resource, Map.of());
            assert opened.isOpen();
        } catch (FileSystemAlreadyExistsException open) {
            // Opened by an earlier call; Path.of finds it by its address.
        }
    }

    private static int number(Path file) {
        Matcher matcher = NUMBERED.matcher(name(file));
        return matcher.matches() ? Integer.parseInt(matcher.group(1)) : Integer.MAX_VALUE;
    }

    private static String name(Path file) {
        return file.getFileName().toString();
    }
}
