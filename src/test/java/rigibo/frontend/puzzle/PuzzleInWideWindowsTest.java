package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;

/** Drawers stand beside the play if the window has room. */
class PuzzleInWideWindowsTest {

    private static final Layout WIDE = Layout.of(1920, 1080, 1);

    private final PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());

    private RecordingCanvas canvas() {
        return RecordingCanvas.of(played.scene, WIDE);
    }

    @Test
    void effectsLeaveThePlayAsLargeAsItIs() {
        double[][] before = canvas().bodies().toArray(double[][]::new);
        played.keys(Key.E);
        assertThat(canvas().bodies().toArray(double[][]::new)).isDeepEqualTo(before);
        assertThat(canvas().middleOf("gravity")[0]).isGreaterThan(Scene.WIDTH);
    }

    /**
     * In a window with the scene's proportions the picture shrinks below a drawer, and grows again.
     */
    @Test
    void thePlayFollowsTheWindow() {
        played.keys(Key.E);
        double[][] wide = canvas().bodies().toArray(double[][]::new);
        double[][] narrow = played.canvas().bodies().toArray(double[][]::new);
        assertThat(narrow[0][1]).isNotEqualTo(wide[0][1]);
        assertThat(canvas().bodies().toArray(double[][]::new)).isDeepEqualTo(wide);
    }

    @Test
    void effectsBesideThePlayAreSwitchedByAClick() {
        played.keys(Key.E);
        assertThat(canvas().plateOf("gravity")).isEqualTo(Color.BRASS);
        double[] at = canvas().middleOf("gravity");
        played.scene.pointerPressed(PointerButton.LEFT, at[0], at[1]);
        assertThat(canvas().plateOf("gravity")).isEqualTo(Color.PANEL_LIT);
    }

    /** Over the play the panel would hide the effect of the last click. */
    @Test
    void theEndStandsBesideThePlay() {
        played.solve();
        RecordingCanvas end = canvas();
        assertThat(end.middleOf("Solved!")[0]).isNegative();
        for (String button : new String[] {"Next level", "Restart", "Levels"}) {
            assertThat(end.middleOf(button)[0]).as(button).isNegative();
        }
        for (double x = 1; x < Scene.WIDTH; x += 8) {
            for (double y = View.BAR_FOOT + 1; y < View.KEYS_TOP; y += 8) {
                assertThat(end.isUnderPanel(x, y)).as("%s, %s", x, y).isFalse();
            }
        }
        double[] next = end.middleOf("Next level");
        played.scene.pointerPressed(PointerButton.LEFT, next[0], next[1]);
        assertThat(played.director.shown).hasSize(1);
    }

    /** At the sides of the level the water would end in an upright edge without a wall. */
    @Test
    void waterFloodsAllThatTheWindowShows() {
        PlayedLevel flooded =
                new PlayedLevel(
                        LevelTexts.level(
                                LevelTexts.with(
                                                "[0, -9.81],",
                                                "[0, -9.81], \"water\": {\"level\": 2},")
                                        .replace(
                                                "\"effects\": [", "\"effects\": [\"buoyancy\", ")));
        RecordingCanvas canvas = RecordingCanvas.of(flooded.scene, WIDE);
        assertThat(canvas.lines())
                .anyMatch(line -> line.x1() <= WIDE.left() && line.x2() >= WIDE.right());
        double[] corner = {WIDE.right() - 1, WIDE.bottom() - 1};
        assertThat(canvas.plateAt(corner[0], corner[1]).alpha()).isLessThan(0.3f);
    }

    /** The box is clicked at its place on the screen, in the scene's coordinates. */
    @Test
    void aClickReachesTheBoxThatIsSeenThere() {
        int before = canvas().bodies().size();
        played.clickBox().turns(2);
        assertThat(canvas().bodies().size()).isEqualTo(before - 1);
    }

    /** With the largest text they are wider than the scene in some languages. */
    @Test
    void keysHaveTheirWordsWithLargeText() {
        PlayedLevel german = new PlayedLevel(PlayedLevel.twoBoxes(), "de", Settings.Motion.FULL);
        Layout narrow = Layout.ALONE.withText(1.3, 1.3);
        assertThat(RecordingCanvas.of(german.scene, narrow).texts()).doesNotContain("Neustart");
        Layout wide = WIDE.withText(1.3, 1.3);
        assertThat(RecordingCanvas.of(german.scene, wide).texts()).contains("Neustart");
    }
}
