package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

/** The buttons of a gamepad, named as in GLFW's mapping, with the keys for which they stand. */
enum GamepadButton {
    UP(GLFW_GAMEPAD_BUTTON_DPAD_UP, GLFW_KEY_UP),
    DOWN(GLFW_GAMEPAD_BUTTON_DPAD_DOWN, GLFW_KEY_DOWN),
    LEFT(GLFW_GAMEPAD_BUTTON_DPAD_LEFT, GLFW_KEY_LEFT),
    RIGHT(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, GLFW_KEY_RIGHT),
    A(GLFW_GAMEPAD_BUTTON_A, GLFW_KEY_ENTER),
    B(GLFW_GAMEPAD_BUTTON_B, GLFW_KEY_ESCAPE),
    /** Starts anew. */
    X(GLFW_GAMEPAD_BUTTON_X, GLFW_KEY_R),
    /** Takes back. */
    Y(GLFW_GAMEPAD_BUTTON_Y, GLFW_KEY_BACKSPACE),
    /** Pauses. */
    START(GLFW_GAMEPAD_BUTTON_START, GLFW_KEY_P),
    /** Selects the next box. */
    RIGHT_BUMPER(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, GLFW_KEY_TAB),
    /** Selects the previous box. */
    LEFT_BUMPER(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, GLFW_KEY_TAB);

    private final int number;
    private final int key;

    GamepadButton(int number, int key) {
        this.number = number;
        this.key = key;
    }

    /** GLFW's. */
    int number() {
        return number;
    }

    /** GLFW's. */
    int key() {
        return key;
    }

    /** Modifiers held together with the key, in GLFW's bits. */
    int modifiers() {
        return this == LEFT_BUMPER ? GLFW_MOD_SHIFT : 0;
    }

    /** Whether the button repeats while it is held. */
    boolean isDirection() {
        return ordinal() <= RIGHT.ordinal();
    }
}
