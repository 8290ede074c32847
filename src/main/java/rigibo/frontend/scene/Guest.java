package rigibo.frontend.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A player whose settings and progress are not saved. */
public final class Guest implements Player {

    private Settings settings;
    private Progress progress = Progress.none();
    private final List<String> notices = new ArrayList<>();

    /** A guest with the given settings. */
    public Guest(Settings settings) {
        this.settings = settings;
    }

    @Override
    public Settings settings() {
        return settings;
    }

    @Override
    public void settings(Settings changed) {
        settings = changed;
    }

    @Override
    public Progress progress() {
        return progress;
    }

    @Override
    public void progress(Progress changed) {
        progress = changed;
    }

    @Override
    public Optional<Path> levels() {
        return Optional.empty();
    }

    @Override
    public Optional<Path> replays() {
        return Optional.empty();
    }

    @Override
    public Optional<Path> measurements() {
        return Optional.empty();
    }

    @Override
    public List<String> notices(Words words) {
        return List.copyOf(notices);
    }

    @Override
    public void forgetNotices() {
        notices.clear();
    }

    @Override
    public void tell(String notice) {
        notices.add(notice);
    }
}
