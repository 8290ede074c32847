package rigibo.frontend.scene;

import java.util.List;

/** A player of whom nothing is remembered. */
public final class Guest implements Player {

    private Settings settings;
    private Progress progress = Progress.none();

    /** Who begins with certain settings. */
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
    public List<String> notices(Words words) {
        return List.of();
    }

    @Override
    public void forgetNotices() {}
}
