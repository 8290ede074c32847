package rigibo.frontend.menu;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;

class KeysSceneTest {

    private final RecordingDirector director = new RecordingDirector();
    private final KeysScene scene = new KeysScene(director);

    private Key key(Action action) {
        return director.settings().keys().of(action);
    }

    @Test
    void theKeyThatIsPressedNextIsTheActionsOwn() {
        click(scene, "Restart");
        assertThat(RecordingCanvas.of(scene).texts()).contains("press a key");
        scene.keyPressed(Key.X);
        assertThat(key(Action.RESTART)).isEqualTo(Key.X);
        assertThat(RecordingCanvas.of(scene).texts()).contains("Restart has the key X now.");
    }

    @Test
    void aTakenKeyIsSwappedAndThePageSaysSo() {
        click(scene, "Hint");
        scene.keyPressed(Key.P);
        assertThat(key(Action.PAUSE)).isEqualTo(Key.H);
        assertThat(RecordingCanvas.of(scene).texts())
                .contains("The key P is for Hint now, and the key H for Pause.");
    }

    @Test
    void keysOfTheWindowAndOfMenusAreRefusedAndTheQuestionStays() {
        scene.keyPressed(Key.ENTER);
        assertThat(scene.isTyping()).as("M would switch the sound off").isTrue();
        for (Key kept : new Key[] {Key.ENTER, Key.M, Key.UP, Key.DIGIT_1}) {
            scene.keyPressed(kept);
            assertThat(RecordingCanvas.of(scene).texts())
                    .contains("This key cannot be changed. Choose another one.");
        }
        assertThat(director.settings().keys()).isEqualTo(KeyBindings.FIRST);
        scene.keyPressed(Key.X);
        assertThat(key(Action.PAUSE)).isEqualTo(Key.X);
    }

    @Test
    void escapeLeavesTheQuestionAndThenThePage() {
        click(scene, "Ghost");
        assertThat(scene.escaped()).isTrue();
        assertThat(director.shown).isEmpty();
        assertThat(scene.escaped()).isTrue();
        assertThat(director.shown.get(0)).isInstanceOf(SettingsScene.class);
        assertThat(director.settings().keys()).isEqualTo(KeyBindings.FIRST);
    }

    @Test
    void allKeysCanBePutBack() {
        click(scene, "Undo");
        scene.keyPressed(Key.U);
        click(scene, "As at first");
        assertThat(director.settings().keys()).isEqualTo(KeyBindings.FIRST);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everythingCanBeRead(String language) {
        RecordingDirector told = new RecordingDirector(language);
        KeysScene page = new KeysScene(told);
        assertThat(Legibility.faults(page)).isEmpty();
        page.keyPressed(Key.DOWN);
        page.keyPressed(Key.ENTER);
        assertThat(Legibility.faults(page)).isEmpty();
        page.keyPressed(Key.DIGIT_1);
        assertThat(Legibility.faults(page)).isEmpty();
        page.keyPressed(Key.C);
        assertThat(Legibility.faults(page)).isEmpty();
    }
}
