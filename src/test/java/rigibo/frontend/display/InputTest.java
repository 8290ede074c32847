package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.lwjgl.glfw.GLFW.*;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Modifier;
import rigibo.frontend.scene.Scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

class InputTest {

    private final List<String> told = new ArrayList<>();
    private boolean hasUseForEscape;
    private boolean isTyping;
    private Optional<Action.Place> place = Optional.empty();
    private KeyBindings chosen = KeyBindings.FIRST;

    private final Scene scene =
            new BlankScene() {
                @Override
                public void held(Set<Modifier> modifiers) {
                    told.add("held " + modifiers);
                }

                @Override
                public Optional<Action.Place> place() {
                    return place;
                }

                @Override
                public void keyPressed(Key key) {
                    told.add(key.name());
                }

                @Override
                public void typed(int codePoint) {
                    told.add(Character.toString(codePoint));
                }

                @Override
                public boolean isTyping() {
                    return isTyping;
                }

                @Override
                public boolean escaped() {
                    return hasUseForEscape;
                }
            };

    private final Input input =
            new Input(
                    scene,
                    () -> told.add("left"),
                    () -> told.add("full screen"),
                    () -> told.add("mute"),
                    () -> told.add("paste"),
                    () -> chosen);

    @Test
    void escapeLeavesOnlyASceneThatHasNoUseForIt() {
        hasUseForEscape = true;
        input.key(GLFW_KEY_ESCAPE, GLFW_PRESS);
        assertThat(told).isEmpty();
        hasUseForEscape = false;
        input.key(GLFW_KEY_ESCAPE, GLFW_PRESS);
        assertThat(told).containsExactly("left");
    }

    @Test
    void everyLetterHasItsKey() {
        input.key(GLFW_KEY_A, GLFW_PRESS);
        input.key(GLFW_KEY_Z, GLFW_PRESS);
        assertThat(told).containsExactly("A", "Z");
    }

    @Test
    void charactersBeyondTheBasicPlaneArriveWhole() {
        input.character("𝄞".codePointAt(0));
        assertThat(told).containsExactly("𝄞");
    }

    @ParameterizedTest
    @CsvSource({"0, held []", "1, held [SHIFT]", "2, held [CONTROL]", "8, held [CONTROL]"})
    void modifiersAreToldByName(int bits, String words) {
        input.modifiers(bits);
        assertThat(told).containsExactly(words);
    }

    @Test
    void aModifiersOwnKeyCountsAtOnce() {
        input.modifiers(0, GLFW_KEY_LEFT_SHIFT, GLFW_PRESS);
        input.modifiers(GLFW_MOD_SHIFT, GLFW_KEY_LEFT_SHIFT, GLFW_RELEASE);
        assertThat(told).containsExactly("held [SHIFT]", "held []");
    }

    @Test
    void mutesAndFillsTheScreenOncePerPress() {
        for (int key : new int[] {GLFW_KEY_M, GLFW_KEY_F11}) {
            input.key(key, GLFW_PRESS);
            input.key(key, GLFW_REPEAT);
            input.key(key, GLFW_RELEASE);
        }
        assertThat(told).containsExactly("mute", "full screen");
    }

    @Test
    void controlAndVPasteOncePerPress() {
        input.key(GLFW_KEY_V, GLFW_PRESS);
        input.modifiers(GLFW_MOD_CONTROL);
        input.key(GLFW_KEY_V, GLFW_PRESS);
        input.key(GLFW_KEY_V, GLFW_REPEAT);
        assertThat(told).containsExactly("V", "held [CONTROL]", "paste");
    }

    @Test
    void anMThatIsWrittenMutesNothing() {
        isTyping = true;
        input.key(GLFW_KEY_M, GLFW_PRESS);
        assertThat(told).doesNotContain("mute");
    }

    @Test
    void aGamepadsButtonsAreKeys() {
        input.gamepad(GamepadButton.A);
        input.gamepad(GamepadButton.LEFT_BUMPER);
        input.gamepad(GamepadButton.B);
        assertThat(told)
                .containsExactly(
                        "held []",
                        "ENTER",
                        "held []",
                        "held [SHIFT]",
                        "TAB",
                        "held []",
                        "held []",
                        "left",
                        "held []");
    }

    @Test
    void aChosenKeyMeansItsActionWhereItMayBeChosen() {
        chosen = chosen.with(Action.RESTART, Key.X).orElseThrow();
        input.key(GLFW_KEY_X, GLFW_PRESS);
        place = Optional.of(Action.Place.LEVEL);
        input.key(GLFW_KEY_X, GLFW_PRESS);
        input.key(GLFW_KEY_R, GLFW_PRESS);
        input.gamepad(GamepadButton.X);
        assertThat(told).containsExactly("X", "R", "held []", "R", "held []");
    }
}
