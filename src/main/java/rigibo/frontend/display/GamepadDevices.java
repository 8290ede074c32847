package rigibo.frontend.display;

import static org.lwjgl.glfw.GLFW.*;

import org.lwjgl.glfw.GLFWGamepadState;
import org.lwjgl.system.MemoryStack;

import java.util.EnumSet;
import java.util.Set;

/** Reads the connected gamepads from GLFW; all of them belong to one player. */
final class GamepadDevices {

    private GamepadDevices() {}

    /** Passes on the state of all devices together. */
    static void poll(Gamepad gamepad) {
        Set<GamepadButton> pressed = EnumSet.noneOf(GamepadButton.class);
        double x = 0;
        double y = 0;
        try (MemoryStack stack = MemoryStack.stackPush()) {
            GLFWGamepadState state = GLFWGamepadState.malloc(stack);
            for (int device = GLFW_JOYSTICK_1; device <= GLFW_JOYSTICK_LAST; device++) {
                if (glfwGetGamepadState(device, state)) {
                    addPressed(state, pressed);
                    x += state.axes(GLFW_GAMEPAD_AXIS_LEFT_X);
                    y += state.axes(GLFW_GAMEPAD_AXIS_LEFT_Y);
                }
            }
        }
        gamepad.turn(pressed, x, y);
    }

    private static void addPressed(GLFWGamepadState state, Set<GamepadButton> pressed) {
        for (GamepadButton button : GamepadButton.values()) {
            if (state.buttons(button.number()) == GLFW_PRESS) {
                pressed.add(button);
            }
        }
    }
}
