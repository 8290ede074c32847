package rigibo.frontend.display;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Scene;

/** A scene that shows nothing, for tests of what it is told. */
abstract class BlankScene implements Scene {

    @Override
    public String title() {
        return "test";
    }

    @Override
    public void step() {}

    @Override
    public void draw(Canvas canvas) {}
}
