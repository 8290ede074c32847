package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import rigibo.frontend.scene.Tap;

import java.util.function.DoubleSupplier;

/**
 * A finger as a pointer. While it is down it hovers, which shows what a mouse shows by hovering;
 * when it presses is the scene's to say, see {@link Tap}.
 */
final class Finger {

    /** A button that is held for so long is looked at; elsewhere it is the other button, s. */
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

    /** Whether it holds the other button, since it rested. */
    private boolean isResting;

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
            case LIFTED, RESTED -> {}
        }
    }

    /** It slid to a point of the window. */
    void slid(double x, double y) {
        if (!isDown) {
            return;
        }
        boolean isGone = tap == Tap.LIFTED || tap == Tap.RESTED && !isResting;
        if (isGone && Math.hypot(x - downX, y - downY) > SLIP) {
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
        boolean isShort = tap == Tap.LIFTED && seconds.getAsDouble() - downAt < REST;
        if (tap == Tap.CHOSEN || isShort) {
            input.mouseButton(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
        }
        leave();
    }

    /** A picture is made, at a time of the clock, s: a finger may have rested. */
    void turn(double now) {
        if (isDown && tap == Tap.RESTED && !isResting && now - downAt >= REST) {
            isResting = true;
            input.mouseButton(GLFW_MOUSE_BUTTON_RIGHT, GLFW_PRESS);
        }
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
        int held = isResting ? GLFW_MOUSE_BUTTON_RIGHT : GLFW_MOUSE_BUTTON_LEFT;
        isResting = false;
        input.mouseButton(held, GLFW_RELEASE);
        input.cursor(AWAY, AWAY);
    }
}
