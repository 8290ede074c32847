package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Modifier;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;

/** A level played by mouse and keys, without a window. */
public final class PlayedLevel {

    private static final String WALL = "\"material\": \"stone\", \"dynamic\": false";
    private static final String HINT = "\"title\"";

    /** Turns in which click, fall and hold are over. */
    public static final int LONG_ENOUGH = 8 * 60;

    /** Scale of the world on the screen without an open drawer, px per m. */
    private static final double SCALE = 80;

    public final RecordingDirector director = new RecordingDirector();
    public final Level level;
    public final Scene scene;

    public PlayedLevel(Level level) {
        this(level, "en", Motion.FULL);
    }

    public PlayedLevel(Level level, String language, Motion motion) {
        this.level = level;
        director.settings(director.settings().withLanguage(language).withMotion(motion));
        scene = new PuzzleScene(director, List.of(level, level), 0);
    }

    /**
     * The ball stands on "box" and the box on the platform; "wall" beside them can be deleted, too.
     */
    public static Level twoBoxes() {
        return LevelTexts.level(
                LevelTexts.with(WALL, WALL + ", \"deletable\": true")
                        .replace(HINT, "\"hint\": {\"en\": \"Look below.\"}, " + HINT));
    }

    /** The ball rolls over the platform's edge and is lost, whatever is clicked. */
    public static Level rollingOff() {
        return LevelTexts.level(
                LevelTexts.with(
                                "\"y\": 2.7, \"radius\": 0.35",
                                "\"y\": 1.71, \"radius\": 0.35, \"vx\": 4")
                        .replace(
                                "\"w\": 2, \"h\": 1}, \"x\": 4.5",
                                "\"w\": 1, \"h\": 1}, \"x\": 3.2"));
    }

    public PlayedLevel turns(int count) {
        for (int i = 0; i < count; i++) {
            scene.step();
        }
        return this;
    }

    /** Clicks at a place of the world, m, without an open drawer. */
    public PlayedLevel click(double x, double y) {
        scene.pointerPressed(PointerButton.LEFT, x * SCALE, Scene.HEIGHT - y * SCALE);
        return this;
    }

    public PlayedLevel clickBox() {
        clickBox(scene);
        return this;
    }

    /** Clicks the box of {@link #twoBoxes} in a scene. */
    public static void clickBox(Scene scene) {
        scene.pointerPressed(PointerButton.LEFT, 4.5 * SCALE, Scene.HEIGHT - 1.85 * SCALE);
    }

    public PlayedLevel clickWall() {
        return click(8, 2);
    }

    /** Clicks the button with these words. */
    public PlayedLevel press(String words) {
        double[] at = canvas().middleOf(words);
        scene.pointerPressed(PointerButton.LEFT, at[0], at[1]);
        return this;
    }

    public PlayedLevel keys(Key... keys) {
        for (Key key : keys) {
            scene.keyPressed(key);
        }
        return this;
    }

    public PlayedLevel shiftTab() {
        scene.held(EnumSet.of(Modifier.SHIFT));
        scene.keyPressed(Key.TAB);
        scene.held(Set.of());
        return this;
    }

    public PlayedLevel solve() {
        return clickBox().turns(LONG_ENOUGH);
    }

    public RecordingCanvas canvas() {
        return RecordingCanvas.of(scene);
    }

    public List<String> texts() {
        return canvas().texts();
    }

    /** The bar's counts: clicks and time. */
    public String counts() {
        return texts().stream()
                .filter(words -> words.matches("\\d+ clicks? .*"))
                .findFirst()
                .orElseThrow();
    }

    public LevelProgress progress() {
        return director.progress().of(level.id(), level.hash());
    }
}
