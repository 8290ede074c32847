package rigibo.frontend.puzzle.replay;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.save.FolderLock;
import rigibo.frontend.save.SafeFile;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;

/** The folder of a level's solved runs: the best and the last. */
public final class ReplayShelf {

    /** Ending of the names of replay files. */
    public static final String ENDING = ".replay.json";

    /** Longest wait for another game that is saving a run; a frame waits with it. */
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

    /** The run with the fewest clicks and, among these, the least time. */
    public Path best() {
        return folder.resolve(id + ".best" + ENDING);
    }

    /** The run that was played last. */
    public Path last() {
        return folder.resolve(id + ".last" + ENDING);
    }

    /** Whether there is a file of a run. */
    public boolean hasRun() {
        return Files.isRegularFile(best()) || Files.isRegularFile(last());
    }

    /** The best run that can still be watched, otherwise the last; empty if neither can be. */
    public Optional<Recording> watchable() {
        return recording(best()).or(() -> recording(last()));
    }

    /** A message about the runs here that were played in another revision of the simulation. */
    public List<Problem> ofOtherRevisions() {
        return Stream.of(best(), last())
                .map(this::read)
                .filter(loaded -> loaded.otherRevision().isPresent())
                .flatMap(loaded -> loaded.problems().stream())
                .toList();
    }

    /**
     * Keeps a solved run as the last one. It also becomes the best one if it is better, or if the
     * best one is of an altered level and can never be watched again. Files of another revision of
     * the simulation are set aside.
     *
     * @throws IOException when nothing can be written there
     */
    public void keep(Recording recording) throws IOException {
        if (recording.steps() > Recording.MOST_STEPS) {
            throw new IOException("it lasted more than an hour");
        }
        lock.during(() -> replace(recording));
    }

    /** Replaces the best run; under the lock, since another game may have kept a better one. */
    private void replace(Recording recording) throws IOException {
        setAside(last());
        setAside(best());
        write(last(), recording);
        Optional<Recording> before = recording(best());
        if (before.isEmpty() || recording.isBetterThan(before.get())) {
            write(best(), recording);
        }
    }

    /** Renames a file of another revision: its name then holds that revision. */
    private void setAside(Path file) throws IOException {
        OptionalInt revision = read(file).otherRevision();
        if (revision.isPresent()) {
            String name = file.getFileName().toString().replace(ENDING, "");
            String kept = name + ".revision-" + revision.getAsInt() + ENDING;
            Files.move(file, folder.resolve(kept), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private Optional<Recording> recording(Path file) {
        return read(file).recording();
    }

    private LoadedReplay read(Path file) {
        return Files.isRegularFile(file) ? loader.load(file) : LoadedReplay.NONE;
    }

    private static void write(Path file, Recording recording) throws IOException {
        byte[] text = ReplayText.of(recording).getBytes(StandardCharsets.UTF_8);
        new SafeFile(file).writeWithoutWaiting(text);
    }
}
