package rigibo.docs.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** {@code ./rigibo site}: writes the site into a folder. */
public final class SiteWriter {

    /** Until most exhibits show what they are about. */
    private static final double GALLERY_SECONDS = 1;

    private SiteWriter() {}

    /** Takes the folder, which is emptied first. */
    public static void main(String[] arguments) throws IOException {
        Path home = Path.of(System.getProperty("rigibo.home", ""));
        Path folder = Path.of(arguments[0]);
        delete(folder);
        copy(home.resolve("build/engine/javadoc"), folder.resolve("javadoc"));
        copy(home.resolve("build/web"), folder.resolve("game"));
        new Site(home, folder).write(GALLERY_SECONDS);
    }

    private static void delete(Path folder) throws IOException {
        for (Path file : inside(folder).stream().sorted(Comparator.reverseOrder()).toList()) {
            Files.delete(file);
        }
    }

    private static void copy(Path from, Path to) throws IOException {
        for (Path file : inside(from)) {
            Path copy = to.resolve(from.relativize(file));
            Files.createDirectories(Files.isDirectory(file) ? copy : copy.getParent());
            if (Files.isRegularFile(file)) {
                Files.copy(file, copy);
            }
        }
    }

    /** A folder and all in it; nothing where it is not there. */
    private static List<Path> inside(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.walk(folder)) {
            return files.collect(Collectors.toList());
        }
    }
}
