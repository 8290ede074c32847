package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.VerbLevels;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingCanvas.Curve;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;

import java.io.IOException;
import java.nio.file.Path;

/** Verbs by mouse and by keys: their effects, sounds and marks. */
class VerbsByHandTest {

    private static final double SCALE = 80;

    private final PlayedLevel rope = new PlayedLevel(VerbLevels.rope());

    @Test
    void aClickOnTheRopeCutsIt() {
        rope.turns(30).click(2, 6.2);
        assertThat(rope.counts()).startsWith("1 click ");
        assertThat(rope.director.sounds.signals).contains("snip");
    }

    /** Cut at two thirds, the upper end stays 1.8 m long below the hook. */
    @Test
    void theEndsHangFromWhereTheClickWas() {
        rope.turns(30).click(2, 6.2).turns(240);
        double upperEnd =
                rope.canvas().curves().stream()
                        .map(Curve::xy)
                        .filter(xy -> Math.abs(xy[1] - (800 - 8 * SCALE)) < 2)
                        .mapToDouble(xy -> (800 - xy[xy.length - 1]) / SCALE)
                        .min()
                        .orElseThrow();
        // Pieces of a rope stretch by a few per cent while they swing.
        assertThat(upperEnd).isBetween(6.2 - 0.1, 6.2 + 0.1);
    }

    @Test
    void tabGoesOnFromTheBoxesToTheRopeAndEnterCuts() {
        rope.keys(Key.TAB, Key.TAB, Key.ENTER);
        assertThat(rope.director.sounds.signals).containsExactly("snip");
        assertThat(rope.counts()).startsWith("1 click ");
    }

    @Test
    void aPinIsPulledByAClickOnIt() {
        PlayedLevel pin = new PlayedLevel(VerbLevels.pin());
        pin.click(7, 5);
        assertThat(pin.director.sounds.signals).containsExactly("pull");
    }

    @Test
    void undoTiesTheRopeAgain() {
        rope.turns(30).click(2, 6.2).turns(30).keys(Key.BACKSPACE);
        assertThat(rope.counts()).startsWith("0 clicks ");
        rope.turns(1).click(2, 6.2);
        assertThat(rope.counts()).as("it is there again").startsWith("1 click ");
    }

    @Test
    void machinesAreHeardAsTheyAreClicked() {
        PlayedLevel machines = new PlayedLevel(VerbLevels.machines());
        machines.click(2, 7).turns(60).click(2, 7).turns(60).click(6, 6).turns(60);
        machines.click(4, 0.7).turns(100);
        assertThat(machines.director.sounds.signals)
                .containsExactly("switch_on", "switch_off", "switch_on", "fuse", "blast");
        assertThat(machines.counts()).startsWith("4 clicks ");
    }

    /** Tab skips floor, ball and platform, and a lit bomb. */
    @Test
    void tabWalksThroughAllThatCanBeActedOn() {
        PlayedLevel machines = new PlayedLevel(VerbLevels.machines());
        machines.keys(Key.TAB, Key.TAB, Key.TAB, Key.ENTER).turns(60);
        machines.keys(Key.TAB, Key.TAB, Key.TAB, Key.ENTER);
        assertThat(machines.director.sounds.signals).startsWith("fuse").endsWith("switch_on");
    }

    /** After the end the sign would cover the panel with the medals. */
    @Test
    void whatAClickDoesIsShownAtThePointerUntilTheGameIsOver() throws IOException {
        PlayedLevel magnet = new PlayedLevel(letGo());
        assertThat(ringsAtPointer(magnet, 5.5, 7.5)).isEqualTo(ringsAtPointer(magnet, 1, 1) + 1);
        magnet.click(5.5, 7.5).turns(PlayedLevel.LONG_ENOUGH);
        assertThat(magnet.progress().isSolved()).isTrue();
        assertThat(ringsAtPointer(magnet, 5.5, 7.5)).isEqualTo(ringsAtPointer(magnet, 1, 1));
    }

    private static Level letGo() throws IOException {
        Path file =
                LevelShelf.files().stream()
                        .filter(level -> level.endsWith("3-03-let-go.json"))
                        .findAny()
                        .orElseThrow();
        return new LevelLoader().load(file).level().orElseThrow();
    }

    /** Number of rings on the screen with the pointer at a place, m. */
    private static int ringsAtPointer(PlayedLevel played, double x, double y) {
        played.scene.pointerMoved(x * SCALE, Scene.HEIGHT - y * SCALE);
        return played.turns(1).canvas().rings().size();
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void theBarSaysWhatAClickDoes(String language) {
        Level level = VerbLevels.of(VerbLevels.ROPE.replace(", \"deletable\": true", ""));
        PlayedLevel played = new PlayedLevel(level, language, Motion.FULL);
        String words = language.equals("en") ? "click a rope to cut it" : "Klick kappt ein Seil";
        assertThat(played.texts()).contains(words);
    }
}
