package rigibo.frontend.display;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;

import java.util.Optional;

/** Finds the control with a certain name in a scene. */
final class Signpost implements Narrator {

    private final String wanted;
    private Optional<Control> found = Optional.empty();

    private Signpost(String wanted) {
        this.wanted = wanted;
    }

    /** Where a pointer uses the control of a name, if the scene offers it at present. */
    static Optional<Demonstration.Click> to(String name, Scene scene) {
        Signpost post = new Signpost(name);
        scene.describe(post);
        return post.found.map(
                at ->
                        new Demonstration.Click(
                                at.x() + at.share() * at.width(), at.y() + at.height() / 2));
    }

    @Override
    public void offers(Control control) {
        if (control.name().equals(wanted)) {
            found = Optional.of(control);
        }
    }

    @Override
    public void says(String words) {}
}
