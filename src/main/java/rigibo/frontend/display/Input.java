package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Modifier;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.widget.Plate;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;

/**
 * Passes GLFW's events to the scene: its callbacks call these methods, and so does the tour.
 * Converts cursor positions from window coordinates to logical pixels.
 */
final class Input {

    private static final Map<Integer, Key> KEYS = keys();

    private final Scene scene;
    private final Runnable close;
    private final Runnable fullScreen;
    private final Runnable mute;
    private final Runnable paste;
    private final Supplier<KeyBindings> chosen;
    private double x = -1;
    private double y = -1;
    private Layout layout = Layout.ALONE;
    private double pixelsPerUnit = 1;
    private Plate wayBack = Plate.NONE;
    private boolean isControlHeld;

    Input(
            Scene scene,
            Runnable close,
            Runnable fullScreen,
            Runnable mute,
            Runnable paste,
            Supplier<KeyBindings> chosen) {
        this.scene = scene;
        this.close = close;
        this.fullScreen = fullScreen;
        this.mute = mute;
        this.paste = paste;
        this.chosen = chosen;
    }

    /**
     * Takes what the window shows.
     *
     * @param perUnit pixels per unit of the window's coordinates, which need not be pixels
     * @param back where a press means Esc
     */
    void shows(Layout shown, double perUnit, Plate back) {
        layout = shown;
        pixelsPerUnit = perUnit;
        wayBack = back;
    }

    void cursor(double windowX, double windowY) {
        x = layout.logicalX(windowX * pixelsPerUnit);
        y = layout.logicalY(windowY * pixelsPerUnit);
        scene.pointerMoved(x, y);
    }

    /** Moves the cursor to a point of the logical window. */
    void point(double logicalX, double logicalY) {
        cursor(layout.windowX(logicalX) / pixelsPerUnit, layout.windowY(logicalY) / pixelsPerUnit);
    }

    void mouseButton(int button, int action) {
        PointerButton which =
                switch (button) {
                    case GLFW_MOUSE_BUTTON_LEFT -> PointerButton.LEFT;
                    case GLFW_MOUSE_BUTTON_RIGHT -> PointerButton.RIGHT;
                    default -> PointerButton.MIDDLE;
                };
        if (action == GLFW_PRESS && wayBack.contains(x, y)) {
            escape();
        } else if (action == GLFW_PRESS) {
            scene.pointerPressed(which, x, y);
        } else {
            scene.pointerReleased(which, x, y);
        }
    }

    /** When a finger presses at the pointer's place. */
    Tap tap() {
        return wayBack.contains(x, y) ? Tap.LIFTED : scene.tap(x, y);
    }

    /** A finger begins or stops choosing what is under the pointer. */
    void choosing(boolean isChoosing) {
        scene.choosing(isChoosing);
    }

    /** Cancels what the pointer has begun. */
    void interrupted() {
        scene.interrupted();
    }

    /**
     * Two fingers moved, in the window's coordinates.
     *
     * @param factor by which the distance between them grew
     * @param windowX where their middle is now
     * @param windowY where their middle is now
     * @param windowDx how far it moved
     * @param windowDy how far it moved
     */
    void pinched(double factor, double windowX, double windowY, double windowDx, double windowDy) {
        double unit = pixelsPerUnit / layout.ratio();
        scene.pinched(
                new Pinch(
                        factor,
                        layout.logicalX(windowX * pixelsPerUnit),
                        layout.logicalY(windowY * pixelsPerUnit),
                        windowDx * unit,
                        windowDy * unit));
    }

    void scroll(double notches) {
        scene.scrolled(notches, x, y);
    }

    /** Modifiers that are held with the next event, in GLFW's bits. */
    void modifiers(int held) {
        Set<Modifier> modifiers = EnumSet.noneOf(Modifier.class);
        if ((held & GLFW_MOD_SHIFT) != 0) {
            modifiers.add(Modifier.SHIFT);
        }
        if ((held & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0) {
            modifiers.add(Modifier.CONTROL);
        }
        isControlHeld = modifiers.contains(Modifier.CONTROL);
        scene.held(modifiers);
    }

    /**
     * Reports the modifiers when a key goes down or up; GLFW counts a modifier's own key only
     * later.
     */
    void modifiers(int held, int key, int action) {
        int own =
                switch (key) {
                    case GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT -> GLFW_MOD_SHIFT;
                    case GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL -> GLFW_MOD_CONTROL;
                    case GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER -> GLFW_MOD_SUPER;
                    default -> 0;
                };
        modifiers(action == GLFW_RELEASE ? held & ~own : held | own);
    }

    void character(int codePoint) {
        scene.typed(codePoint);
    }

    private void escape() {
        if (!scene.escaped()) {
            close.run();
        }
    }

    /** Handles a key of the keyboard, which means what the player has chosen. */
    void key(int key, int action) {
        key(key, action, chosen.get());
    }

    private void key(int key, int action, KeyBindings bindings) {
        if (action == GLFW_RELEASE) {
            return;
        }
        if (key == GLFW_KEY_ESCAPE) {
            escape();
        } else if (key == GLFW_KEY_F11) {
            once(fullScreen, action);
        } else if (key == GLFW_KEY_V && isControlHeld) {
            once(paste, action);
        } else if (key == GLFW_KEY_M && !scene.isTyping()) {
            once(mute, action);
        } else if (KEYS.containsKey(key)) {
            meant(KEYS.get(key), bindings).ifPresent(scene::keyPressed);
        }
    }

    private Optional<Key> meant(Key pressed, KeyBindings bindings) {
        return scene.place()
                .map(place -> bindings.meant(place, pressed))
                .orElse(Optional.of(pressed));
    }

    /** Ignores repetitions of held keys that switch something. */
    private static void once(Runnable toggle, int action) {
        if (action == GLFW_PRESS) {
            toggle.run();
        }
    }

    /** Handles a gamepad's button that was pressed or repeats; it means the same for everybody. */
    void gamepad(GamepadButton button) {
        modifiers(button.modifiers());
        key(button.key(), GLFW_PRESS, KeyBindings.FIRST);
        modifiers(0);
    }

    /** Presses and releases the first key of a command. */
    void press(Key meant) {
        KEYS.forEach(
                (code, key) -> {
                    if (key == meant && code != GLFW_KEY_KP_ENTER) {
                        key(code, GLFW_PRESS, KeyBindings.FIRST);
                        key(code, GLFW_RELEASE, KeyBindings.FIRST);
                    }
                });
    }

    private static Map<Integer, Key> keys() {
        Map<Integer, Key> keys = new HashMap<>();
        keys.put(GLFW_KEY_ENTER, Key.ENTER);
        keys.put(GLFW_KEY_KP_ENTER, Key.ENTER);
        keys.put(GLFW_KEY_SPACE, Key.SPACE);
        keys.put(GLFW_KEY_TAB, Key.TAB);
        keys.put(GLFW_KEY_BACKSPACE, Key.BACKSPACE);
        keys.put(GLFW_KEY_DELETE, Key.DELETE);
        keys.put(GLFW_KEY_PERIOD, Key.PERIOD);
        keys.put(GLFW_KEY_LEFT_BRACKET, Key.LEFT_BRACKET);
        keys.put(GLFW_KEY_RIGHT_BRACKET, Key.RIGHT_BRACKET);
        keys.put(GLFW_KEY_HOME, Key.HOME);
        keys.put(GLFW_KEY_UP, Key.UP);
        keys.put(GLFW_KEY_DOWN, Key.DOWN);
        keys.put(GLFW_KEY_LEFT, Key.LEFT);
        keys.put(GLFW_KEY_RIGHT, Key.RIGHT);
        keys.put(GLFW_KEY_F1, Key.F1);
        for (char letter = 'A'; letter <= 'Z'; letter++) {
            keys.put(GLFW_KEY_A + letter - 'A', Key.valueOf(String.valueOf(letter)));
        }
        keys.put(GLFW_KEY_1, Key.DIGIT_1);
        keys.put(GLFW_KEY_2, Key.DIGIT_2);
        keys.put(GLFW_KEY_3, Key.DIGIT_3);
        keys.put(GLFW_KEY_4, Key.DIGIT_4);
        keys.put(GLFW_KEY_5, Key.DIGIT_5);
        keys.put(GLFW_KEY_6, Key.DIGIT_6);
        keys.put(GLFW_KEY_7, Key.DIGIT_7);
        return keys;
    }
}
