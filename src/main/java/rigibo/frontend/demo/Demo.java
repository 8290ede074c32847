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

    /** Its name, by which the menu and links find it. */
    String name();

    /** The effects that the scene declares. */
    Effects effects();

    /**
     * Why the scene declares each effect, and what some others would add, with numbers where it has
     * any.
     */
    List<EffectReason> reasons();

    /** The initial view. */
    Camera camera();

    /** The initial view in a window of a hand that is higher than wide: no plates lie beside it. */
    default Camera cameraUpright() {
        return camera();
    }

    /** Puts the bodies on a fresh workbench. */
    void build(Workbench bench);

    /** Controls and readouts, from top to bottom. */
    List<Widget> widgets();

    /**
     * Whether its point is how it differs at another accuracy; if so, the side plate shows the
     * ghost.
     */
    default boolean wantsGhost() {
        return false;
    }

    /** Whether its world goes on to the right of the scene, where no plate may cover it. */
    default boolean goesOnToTheRight() {
        return false;
    }

    /** A link has set the controls: the demo begins anew with their values. */
    default void followed() {}

    /** Before each step. */
    default void beforeStep(Workbench bench) {}

    /** After each step. */
    default void afterStep(Workbench bench) {}

    /** Draws what only this demo shows, above the bodies. */
    default void draw(Workbench bench, Canvas canvas) {}

    /** Reports the time that the last frame took to draw, ns. */
    default void drawn(long nanos) {}

    /** Reports a press of the right button at a point of the world, m. */
    default void rightClick(Workbench bench, double x, double y) {}

    /** Handles a key that is not one of the shared keys. */
    default void key(Workbench bench, Key key) {}
}
