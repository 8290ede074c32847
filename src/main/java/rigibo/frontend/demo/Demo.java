package rigibo.frontend.demo;

import rigibo.backend.effect.Effects;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.widget.Widget;

import java.util.List;

/** One demo: its effects, bodies, controls and readouts. */
interface Demo {

    /** The window's title and the name on the screen. */
    String title();

    /** What the scene calls for. */
    Effects effects();

    /** What each of them is for here, and what others would do that it has numbers for. */
    List<EffectReason> reasons();

    /** Where to look. */
    Camera camera();

    /** Puts the bodies on a fresh workbench. */
    void build(Workbench bench);

    /** Controls and readouts, from above. */
    List<Widget> widgets();

    /** Whether its point is how it differs at another accuracy: then the ghost's side turns up. */
    default boolean wantsGhost() {
        return false;
    }

    /** Before each step. */
    default void beforeStep(Workbench bench) {}

    /** After each step. */
    default void afterStep(Workbench bench) {}

    /** Draws what is special about it, above the bodies. */
    default void draw(Workbench bench, Canvas canvas) {}

    /** The last frame took this long to draw, ns. */
    default void drawn(long nanos) {}

    /** The right button went down, world m. */
    default void rightClick(Workbench bench, double x, double y) {}

    /** A key that is not shared. */
    default void key(Workbench bench, Key key) {}
}
