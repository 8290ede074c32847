package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;

/** A scene whose pointer and keys go to its tiles; overrides what it handles in another way. */
public interface TiledScene extends Scene {

    /** Its tiles at present. */
    Tiles tiles();

    @Override
    default void describe(Narrator narrator) {
        tiles().describe(narrator);
    }

    @Override
    default void pointerMoved(double x, double y) {
        tiles().pointerMoved(x, y);
    }

    @Override
    default Tap tap(double x, double y) {
        return Tap.LIFTED;
    }

    @Override
    default void pointerPressed(PointerButton button, double x, double y) {
        tiles().pointerPressed(button, x, y);
    }

    @Override
    default void keyPressed(Key key) {
        tiles().keyPressed(key);
    }
}
