package rigibo.frontend.save;

import dev.dirs.ProjectDirectories;

import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * The folders of the player's files.
 *
 * @param settings the folder of the settings
 * @param data the folder of the progress and the player's other files
 */
public record Places(Path settings, Path data) {

    /** Where the system keeps such files: under Linux by the rules of freedesktop.org. */
    public static Places ofSystem() {
        ProjectDirectories own = ProjectDirectories.from("", "", "RigiBo");
        return new Places(Path.of(own.configDir), Path.of(own.dataDir));
    }

    /** All in one folder, which need not exist yet. */
    public static Places in(Path folder) {
        Path whole = folder.toAbsolutePath().normalize();
        return new Places(whole, whole);
    }

    /** The folder of solved runs. */
    public Path replays() {
        return data.resolve("replays");
    }

    /** The folder of levels that the player makes. */
    public Path levels() {
        return data.resolve("levels");
    }

    /** The folder of what the player measures. */
    public Path measurements() {
        return data.resolve("measurements");
    }

    /** The folder, within that of the player's levels, of drafts that were not saved. */
    public static Path drafts(Path levels) {
        return levels.resolve("unsaved");
    }

    /** Every folder that files are kept in. */
    Stream<Path> all() {
        return Stream.of(settings, data, replays(), levels(), drafts(levels()), measurements());
    }

    Path settingsFile() {
        return settings.resolve("settings.json");
    }

    Path progressFile() {
        return data.resolve("progress.json");
    }
}
