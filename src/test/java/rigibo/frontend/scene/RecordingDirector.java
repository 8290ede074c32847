package rigibo.frontend.scene;

import java.util.ArrayList;
import java.util.List;

/** Keeps what was asked of it. */
public final class RecordingDirector implements Director {

    /** The scenes that were to be shown, in their order. */
    public final List<Scene> shown = new ArrayList<>();

    @Override
    public void show(Scene scene) {
        shown.add(scene);
    }

    @Override
    public void showMenu() {}

    @Override
    public void quit() {}
}
