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
import java.util.Map;

/**
 * Finds the folder of the game's levels: in the source tree if the game was started from one, so
 * that an author sees edits at once, otherwise beside the schema on the class path.
 */
final class LevelFolder {

    private LevelFolder() {}

    /** The folder; the schema is a resource of the class path. */
    static Path of(String resource) {
        Path sources = Path.of(System.getProperty("rigibo.home", ""), "levels");
        return Files.exists(sources.resolve("level.schema.json"))
                ? shortened(sources.toAbsolutePath())
                : packaged(resource);
    }

    private static Path packaged(String resource) {
        URL schema = LevelFolder.class.getResource(resource);
        if (schema == null) {
            throw new IllegalStateException(resource + " is missing");
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

    /** The path as a user in the working directory would type it, if that is shorter. */
    private static Path shortened(Path folder) {
        Path here = Path.of("").toAbsolutePath();
        return folder.startsWith(here) ? here.relativize(folder) : folder;
    }
}
