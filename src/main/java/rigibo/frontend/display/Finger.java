package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import rigibo.frontend.scene.Tap;

import java.util.function.DoubleSupplier;

/**
 * A finger as a pointer. While it is down it hovers, which shows what a mouse shows by hovering;
 * when it presses is the scene's to say, see {@link Tap}.
 */
final class Finger {

    /** A button that is held for so long is looked at, s. */
    private static final double REST = 0.8;

    /** A finger that slid so far off a button does not mean it, in the window's coordinates. */
    private static final double SLIP = 22;

    /** Where nothing is that a finger which is gone could seem to be over. */
    private static final double AWAY = -1000;

    private final Input input;
    private final DoubleSupplier seconds;
    private Tap tap = Tap.AT_ONCE;
    private double downX;
    private double downY;
    private double downAt;
    private boolean isDown;

    /** A finger that comes to an input, timed by a clock in s. */
    Finger(Input input, DoubleSupplier seconds) {
        this.input = input;
        this.seconds = seconds;
    }

    /** It came down at a point of the window. */
    void down(double x, double y) {
        isDown = true;
        downX = x;
        downY = y;
        downAt = seconds.getAsDouble();
        input.cursor(x, y);
        tap = input.tap();
        switch (tap) {
            case AT_ONCE -> input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
            case CHOSEN -> input.choosing(true);
            case LIFTED -> {}
        }
    }

    /** It slid to a point of the window. */
    void slid(double x, double y) {
        if (!isDown) {
            return;
        }
        if (tap == Tap.LIFTED && Math.hypot(x - downX, y - downY) > SLIP) {
            leave();
            return;
        }
        input.cursor(x, y);
        if (tap == Tap.CHOSEN) {
            input.choosing(true);
        }
    }

    /** It was lifted. */
    void lifted() {
        if (!isDown) {
            return;
        }
        boolean isMeant = tap == Tap.CHOSEN || seconds.getAsDouble() - downAt < REST;
        if (tap != Tap.AT_ONCE && isMeant) {
            input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
        }
        leave();
    }

    /** The system took it, or a second one came: nothing is pressed any more. */
    void taken() {
        if (isDown) {
            input.interrupted();
            leave();
        }
    }

    private void leave() {
        isDown = false;
        input.choosing(false);
        input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
        input.cursor(AWAY, AWAY);
    }
}
