package rigibo.frontend.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.Map;

class KeyBindingsTest {

    private final KeyBindings first = KeyBindings.FIRST;

    @Test
    void aTakenKeyIsSwappedWithAllThatHaveItInTheSamePlaces() {
        KeyBindings changed = first.with(Action.RESTART, Key.C).orElseThrow();
        assertThat(changed.of(Action.RESTART)).isEqualTo(Key.C);
        assertThat(changed.of(Action.COPY)).as("in levels").isEqualTo(Key.R);
        assertThat(changed.of(Action.CONTROLS)).as("in demos").isEqualTo(Key.R);
        assertThat(changed.with(Action.RESTART, Key.R)).contains(first);
    }

    @Test
    void whatIsElsewhereKeepsItsKey() {
        KeyBindings changed = first.with(Action.HINT, Key.T).orElseThrow();
        assertThat(changed.of(Action.PLATES)).isEqualTo(Key.T);
    }

    /** A copy has its key in replays, too, where P would be that of two actions. */
    @Test
    void aSwapThatGivesOneKeyToTwoActionsIsRefused() {
        KeyBindings changed = first.with(Action.HINT, Key.SPACE).orElseThrow();
        assertThat(changed.with(Action.HINT, Key.C)).isEmpty();
    }

    @Test
    void eachActionKeepsItsKeyWhateverElseWasPressed() {
        KeyBindings changed = first.with(Action.RESTART, Key.X).orElseThrow();
        Action.Place level = Action.Place.LEVEL;
        assertThat(changed.meant(level, Key.X)).contains(Key.R);
        assertThat(changed.meant(level, Key.R)).as("has lost its action").isEmpty();
        assertThat(changed.meant(level, Key.P)).contains(Key.P);
        assertThat(changed.meant(level, Key.ENTER)).contains(Key.ENTER);
    }

    @Test
    void anActionThatIsNewerThanAChoiceGetsAFreeKey() {
        KeyBindings read = KeyBindings.completed(Map.of(Action.HINT, Key.P));
        assertThat(read.of(Action.HINT)).isEqualTo(Key.P);
        assertThat(read.of(Action.PAUSE)).isNotEqualTo(Key.P);
        assertThat(read.of(Action.HALT)).as("keeps its first key").isEqualTo(Key.SPACE);
    }

    @Test
    void keysThatSteerMenusAreNoChoice() {
        assertThat(KeyBindings.FREE)
                .doesNotContain(
                        Key.ENTER, Key.TAB, Key.UP, Key.DOWN, Key.LEFT, Key.RIGHT, Key.F1, Key.M);
        Map<Action, Key> keys = new EnumMap<>(first.keys());
        keys.put(Action.HINT, Key.ENTER);
        assertThatThrownBy(() -> new KeyBindings(keys)).hasMessageContaining("free key");
    }
}
