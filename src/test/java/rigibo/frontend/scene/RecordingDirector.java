package rigibo.frontend.scene;

import java.util.ArrayList;
import java.util.List;

/** Keeps what was asked of it. */
public final class RecordingDirector implements Director {

    /** The scenes that were to be shown, in their order. */
    public final List<Scene> shown = new ArrayList<>();

    private Settings settings = Settings.initial("en");
    private Progress progress = Progress.none();

    @Override
    public void show(Scene scene) {
        shown.add(scene);
    }

    @Override
    public void showMenu() {}

    @Override
    public void showLevels() {}

    @Override
    public void quit() {}

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
    public Words words() {
        return new Words(settings.language());
    }

    @Override
    public Sounds sounds() {
        return new Silence();
    }
}
