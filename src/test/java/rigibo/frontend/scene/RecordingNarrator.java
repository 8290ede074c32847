package rigibo.frontend.scene;

import java.util.ArrayList;
import java.util.List;

/** Keeps what a scene says of itself. */
public final class RecordingNarrator implements Narrator {

    private final List<Control> controls = new ArrayList<>();
    private final List<String> said = new ArrayList<>();

    /** Records what a scene says now. */
    public static RecordingNarrator of(Scene scene) {
        RecordingNarrator narrator = new RecordingNarrator();
        scene.describe(narrator);
        return narrator;
    }

    @Override
    public void offers(Control control) {
        controls.add(control);
    }

    @Override
    public void says(String words) {
        said.add(words);
    }

    public List<Control> controls() {
        return controls;
    }

    public List<String> said() {
        return said;
    }

    /** The names of all controls. */
    public List<String> names() {
        return controls.stream().map(Control::name).toList();
    }

    /** The control of a name. */
    public Control control(String name) {
        return controls.stream().filter(it -> it.name().equals(name)).findFirst().orElseThrow();
    }

    /** Presses a control as the page does. */
    public static void press(Scene scene, Control control) {
        double x = control.x() + control.share() * control.width();
        double y = control.y() + control.height() / 2;
        scene.pointerMoved(x, y);
        scene.pointerPressed(PointerButton.LEFT, x, y);
        scene.pointerReleased(PointerButton.LEFT, x, y);
    }
}
