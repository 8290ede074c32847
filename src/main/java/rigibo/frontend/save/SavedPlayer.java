package rigibo.frontend.save;

import rigibo.frontend.scene.Player;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;

/**
 * A player whose settings and progress are saved. Both are read once, and written soon after each
 * change by a thread of their own, so that a change never waits for a disk. If writing fails, the
 * values are kept and written again later.
 */
public final class SavedPlayer implements Player, AutoCloseable {

    /**
     * Time from a change until it is written, ms, so that a slider being dragged is not written
     * each turn.
     */
    private static final long SOON = 300;

    /** Time from a failure to the next try, ms. */
    private static final long LATER = 10_000;

    private final Kept<Settings> settings;
    private final Kept<Progress> progress;
    private final Path replays;
    private final Path levels;
    private final Path measurements;
    private final List<String> told = new ArrayList<>();
    private final AtomicBoolean isDue = new AtomicBoolean();
    private final Writer writer = new Writer();

    /**
     * Reads the files. Never fails: a file that cannot be read becomes a notice.
     *
     * @param systemLanguage ISO 639 code of the system's language, for the first start
     */
    public SavedPlayer(Places places, String systemLanguage) {
        this(places, Settings.initial(systemLanguage));
    }

    /**
     * Reads the files, as the other constructor does.
     *
     * @param initial settings until the player has chosen others
     */
    public SavedPlayer(Places places, Settings initial) {
        Leftovers.sweep(places.all());
        settings = new Kept<>(places.settingsFile(), new SettingsFormat(initial));
        progress = new Kept<>(places.progressFile(), new ProgressFormat());
        replays = places.replays();
        levels = places.levels();
        measurements = places.measurements();
    }

    @Override
    public Settings settings() {
        return settings.value();
    }

    @Override
    public void settings(Settings changed) {
        settings.value(changed);
        saveIn(SOON);
    }

    @Override
    public Progress progress() {
        return progress.value();
    }

    @Override
    public void progress(Progress changed) {
        progress.value(changed);
        saveIn(SOON);
    }

    @Override
    public List<String> notices(Words words) {
        Stream<String> ofFiles =
                Stream.concat(settings.notices().stream(), progress.notices().stream())
                        .map(notice -> notice.in(words));
        return Stream.concat(ofFiles, told.stream()).toList();
    }

    @Override
    public void forgetNotices() {
        settings.forgetNotices();
        progress.forgetNotices();
        told.clear();
    }

    @Override
    public void tell(String notice) {
        told.add(notice);
    }

    @Override
    public Optional<Path> levels() {
        return Optional.of(levels);
    }

    @Override
    public Optional<Path> measurements() {
        return Optional.of(measurements);
    }

    @Override
    public Optional<Path> replays() {
        return Optional.of(replays);
    }

    private void saveIn(long millis) {
        if (!writer.isClosed() && isDue.compareAndSet(false, true)) {
            writer.in(millis, this::save);
        }
    }

    /** Writes all changes that are not on disk yet. */
    synchronized void save() {
        isDue.set(false);
        // Both, whatever becomes of the first.
        boolean isDone = settings.save() & progress.save();
        if (!isDone) {
            saveIn(LATER);
        }
    }

    /** Writes all changes that are not on disk yet, and waits for that. */
    @Override
    public void close() {
        writer.close();
        save();
    }
}
