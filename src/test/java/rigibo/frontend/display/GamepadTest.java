package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Simulates the use of a gamepad without a real one. */
class GamepadTest {

    private final List<GamepadButton> presses = new ArrayList<>();
    private final Gamepad gamepad = new Gamepad(presses::add);

    private void hold(int turns, Set<GamepadButton> buttons, double x, double y) {
        for (int i = 0; i < turns; i++) {
            gamepad.turn(buttons, x, y);
        }
    }

    private void letGo() {
        hold(1, Set.of(), 0, 0);
    }

    @Test
    void aButtonThatIsHeldIsPressedOnce() {
        hold(200, Set.of(GamepadButton.A), 0, 0);
        assertThat(presses).containsExactly(GamepadButton.A);
        letGo();
        hold(1, Set.of(GamepadButton.A), 0, 0);
        assertThat(presses).containsExactly(GamepadButton.A, GamepadButton.A);
    }

    @Test
    void aDirectionThatIsHeldWaitsThenRepeatsItself() {
        hold(24, Set.of(GamepadButton.DOWN), 0, 0);
        assertThat(presses).hasSize(1);
        hold(1, Set.of(GamepadButton.DOWN), 0, 0);
        assertThat(presses).hasSize(2);
        hold(7, Set.of(GamepadButton.DOWN), 0, 0);
        assertThat(presses).hasSize(3).containsOnly(GamepadButton.DOWN);
    }

    @ParameterizedTest
    @CsvSource({"1, 0.3, RIGHT", "-0.7, 0, LEFT", "0.2, 1, DOWN", "0, -0.9, UP"})
    void theStickPressesTheDirectionItPointsTo(double x, double y, GamepadButton button) {
        hold(3, Set.of(), x, y);
        assertThat(presses).containsExactly(button);
    }

    @Test
    void aStickThatTremblesAtItsThresholdPressesOnce() {
        for (int i = 0; i < 10; i++) {
            hold(1, Set.of(), 0.61, 0);
            hold(1, Set.of(), 0.45, 0);
        }
        assertThat(presses).containsExactly(GamepadButton.RIGHT);
        hold(1, Set.of(), 0.3, 0);
        hold(1, Set.of(), 0.61, 0);
        assertThat(presses).hasSize(2);
    }

    @Test
    void aStickAtRestIsNeverQuiteInTheMiddleAndPressesNothing() {
        hold(100, Set.of(), 0.12, -0.2);
        assertThat(presses).isEmpty();
    }

    @Test
    void stickAndCrossTogetherAreOnePress() {
        hold(5, Set.of(GamepadButton.UP), 0, -1);
        assertThat(presses).containsExactly(GamepadButton.UP);
    }

    @Test
    void anotherButtonStartsTheWaitAnew() {
        hold(20, Set.of(GamepadButton.DOWN), 0, 0);
        hold(20, Set.of(GamepadButton.DOWN, GamepadButton.X), 0, 0);
        assertThat(presses).containsExactly(GamepadButton.DOWN, GamepadButton.X);
    }
}
