package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingCanvas.Ring;
import rigibo.frontend.scene.Settings.Motion;

import java.util.Set;
import java.util.TreeSet;

/** Every refused click is shown, with its reason. */
class RefusedClickTest {

    private static final int SEEN = 72;

    private final PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());

    /** Position of the cooldown's ring at the pointer, px; the pointer is at the wall. */
    private static double pointerRing(PlayedLevel of) {
        return of.canvas().rings().stream()
                .filter(ring -> Math.abs(ring.x() - 640) < 20 && ring.y() > 100)
                .mapToDouble(Ring::x)
                .findFirst()
                .orElseThrow();
    }

    private static Set<Double> pointerRings(PlayedLevel of) {
        Set<Double> places = new TreeSet<>();
        for (int turn = 0; turn < 20; turn++) {
            places.add(pointerRing(of));
            of.turns(1);
        }
        return places;
    }

    private static boolean isCrossed(RecordingCanvas canvas, double x, double y) {
        return canvas.lines().stream()
                        .filter(line -> line.color().equals(Color.BAD))
                        .filter(line -> (line.x1() + line.x2()) / 2 == x)
                        .filter(line -> (line.y1() + line.y2()) / 2 == y)
                        .count()
                == 2;
    }

    @Test
    void duringTheCooldownTheRingShakesAndIsStillAgain() {
        played.clickBox().turns(5).clickWall();
        assertThat(played.texts()).contains("wait for the ring");
        assertThat(pointerRings(played)).hasSizeGreaterThan(10);
        assertThat(pointerRings(played)).containsExactly(640.0);
    }

    @Test
    void withReducedMotionNothingShakesButTheCrossTells() {
        PlayedLevel calm = new PlayedLevel(PlayedLevel.twoBoxes(), "en", Motion.REDUCED);
        calm.clickBox().turns(5).clickWall();
        assertThat(isCrossed(calm.canvas(), 640, 640)).isTrue();
        assertThat(pointerRings(calm)).containsExactly(640.0);
    }

    @Test
    void aBodyThatStaysIsOutlinedAndCrossed() {
        PlayedLevel one = new PlayedLevel(LevelTexts.sound());
        one.clickWall();
        assertThat(one.texts()).contains("this one stays");
        assertThat(one.canvas().moods()).contains(Canvas.Mood.GHOST);
        assertThat(isCrossed(one.canvas(), 640, 640)).isTrue();
    }

    @Test
    void aClickBesideEverythingIsCrossed() {
        played.click(1, 8);
        assertThat(played.texts()).contains("nothing there");
        assertThat(isCrossed(played.canvas(), 80, 160)).isTrue();
    }

    @Test
    void whatIsSaidOfItGoesAgain() {
        played.click(1, 8).turns(SEEN);
        assertThat(played.texts()).doesNotContain("nothing there");
        assertThat(isCrossed(played.canvas(), 80, 160)).isFalse();
    }

    @Test
    void clicksBeyondTheLevelsNumberAreRefused() {
        String text =
                LevelTexts.with("\"par\": 1", "\"par\": 1, \"maxClicks\": 1")
                        .replace("\"dynamic\": false", "\"dynamic\": false, \"deletable\": true");
        PlayedLevel limited = new PlayedLevel(LevelTexts.level(text));
        limited.clickBox().turns(60).clickWall();
        assertThat(limited.texts()).contains("no clicks left");
    }

    @Test
    void aClickOnATryThatIsOverIsRefused() {
        played.solve().clickWall();
        assertThat(played.texts()).contains("the try is over");
    }

    @Test
    void undoWithoutAClickIsRefused() {
        played.keys(Key.BACKSPACE);
        assertThat(played.texts()).contains("nothing to undo");
    }

    @Test
    void aDeletionSaysNothing() {
        played.click(1, 8).clickBox();
        assertThat(played.texts()).doesNotContain("nothing there");
        assertThat(played.counts()).startsWith("1 click ");
    }
}
