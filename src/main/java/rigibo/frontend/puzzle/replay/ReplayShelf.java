package rigibo.frontend.puzzle.replay;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.save.FolderLock;
import rigibo.frontend.save.SafeFile;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/** Where solved runs of a level are kept: the best and the last. */
public final class ReplayShelf {

    /** How the names of replay files end. */
    public static final String ENDING = ".replay.json";

    /** How long another game that keeps a run is waited for: a frame waits with it. */
    private static final Duration PATIENCE = Duration.ofMillis(100);

    private final Path folder;
    private final FolderLock lock;
    private final String id;
    private final ReplayLoader loader;

    /** A level's place in a folder, which need not exist yet. */
    public ReplayShelf(Path folder, Level level) {
        this.folder = folder;
        lock = new FolderLock(folder, PATIENCE);
        id = level.id();
        loader = new ReplayLoader(List.of(level));
    }

    /** Fewest clicks, then least time. */
    public Path best() {
        return folder.resolve(id + ".best" + ENDING);
    }

    /** The one that was played last. */
    public Path last() {
        return folder.resolve(id + ".last" + ENDING);
    }

    /** The best that can still be watched, else the last; nothing where neither can. */
    public Optional<Recording> watchable() {
        return recording(best()).or(() -> recording(last()));
    }

    /**
     * Keeps a solved run as the last, and as the best where it is, or where the best is of an
     * altered level or of another version, and could never be watched again.
     *
     * @throws IOException when nothing can be written there
     */
    public void keep(Recording recording) throws IOException {
        if (recording.steps() > Recording.MOST_STEPS) {
            throw new IOException("it lasted more than an hour");
        }
        lock.during(() -> replace(recording));
    }

    /** Under the lock: another game may have kept a better one. */
    private void replace(Recording recording) throws IOException {
        write(last(), recording);
        Optional<Recording> before = recording(best());
        if (before.isEmpty() || recording.isBetterThan(before.get())) {
            write(best(), recording);
        }
    }

    private Optional<Recording> recording(Path file) {
        return Files.isRegularFile(file) ? loader.load(file).recording() : Optional.empty();
    }

    private static void write(Path file, Recording recording) throws IOException {
        byte[] text = ReplayText.of(recording).getBytes(StandardCharsets.UTF_8);
        new SafeFile(file).writeWithoutWaiting(text);
    }
}
