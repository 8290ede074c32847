package rigibo.frontend.display;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Turns the state of a gamepad's buttons and left stick into key presses, in each turn of the loop.
 * The stick acts as the direction pad, in one direction at a time; a held direction repeats, as a
 * key does.
 */
final class Gamepad {

    /** Deflection of the stick from which on it counts, and below which it no longer does. */
    private static final double PUSHED = 0.6;

    private static final double LET_GO = 0.4;

    /**
     * Turns of 1/60 s until a held direction repeats for the first time, and between repetitions.
     */
    private static final int FIRST_REPEAT = 24;

    private static final int NEXT_REPEAT = 7;

    private final Consumer<GamepadButton> presses;
    private Set<GamepadButton> held = EnumSet.noneOf(GamepadButton.class);
    private Optional<GamepadButton> stick = Optional.empty();
    private int turnsHeld;

    /** Reports every press. */
    Gamepad(Consumer<GamepadButton> presses) {
        this.presses = presses;
    }

    /**
     * One turn of the loop.
     *
     * @param pressed the buttons that are down
     * @param stickX of the left stick, −1 to 1, to the right
     * @param stickY −1 to 1, downwards
     */
    void turn(Set<GamepadButton> pressed, double stickX, double stickY) {
        stick = pushed(stickX, stickY);
        Set<GamepadButton> down = EnumSet.noneOf(GamepadButton.class);
        down.addAll(pressed);
        stick.ifPresent(down::add);
        turnsHeld = down.equals(held) ? turnsHeld + 1 : 0;
        for (GamepadButton button : down) {
            if (!held.contains(button) || button.isDirection() && isRepeated()) {
                presses.accept(button);
            }
        }
        held = down;
    }

    private boolean isRepeated() {
        return turnsHeld >= FIRST_REPEAT && (turnsHeld - FIRST_REPEAT) % NEXT_REPEAT == 0;
    }

    /**
     * Direction of the stick along its larger deflection; between the two thresholds it stays as it
     * was.
     */
    private Optional<GamepadButton> pushed(double x, double y) {
        double way = Math.max(Math.abs(x), Math.abs(y));
        if (way < LET_GO) {
            return Optional.empty();
        }
        if (way < PUSHED) {
            return stick;
        }
        return Optional.of(
                Math.abs(x) > Math.abs(y)
                        ? x > 0 ? GamepadButton.RIGHT : GamepadButton.LEFT
                        : y > 0 ? GamepadButton.DOWN : GamepadButton.UP);
    }
}
