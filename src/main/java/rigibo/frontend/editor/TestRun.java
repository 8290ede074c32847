package rigibo.frontend.editor;

import rigibo.frontend.puzzle.PuzzleScene;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Guest;
import rigibo.frontend.scene.Player;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Sounds;
import rigibo.frontend.scene.Words;

import java.util.Optional;

/**
 * A draft played in the editor's window. Every exit of the game leads back to the editor. Progress
 * made here is forgotten then, since the level is not finished.
 */
final class TestRun implements Director {

    private final Director director;
    private final Player guest;
    private final PuzzleScene scene;
    private boolean isLeft;

    TestRun(Director director, Level level) {
        this.director = director;
        guest = new Guest(director.settings());
        scene = PuzzleScene.ofTrial(this, level);
    }

    PuzzleScene scene() {
        return scene;
    }

    boolean isLeft() {
        return isLeft;
    }

    void leave() {
        isLeft = true;
    }

    /** The clicks that won. */
    Optional<Solution> solution() {
        return scene.solution();
    }

    @Override
    public void show(Scene other) {
        leave();
    }

    @Override
    public void showMenu() {
        leave();
    }

    @Override
    public void showLevels() {
        leave();
    }

    @Override
    public void quit() {
        director.quit();
    }

    /** A player whose progress is forgotten after the try. */
    @Override
    public Player player() {
        return guest;
    }

    /** The settings of the editor's player, who may change them meanwhile. */
    @Override
    public Settings settings() {
        return director.settings();
    }

    @Override
    public void settings(Settings changed) {
        director.settings(changed);
    }

    @Override
    public void say(String words) {
        director.say(words);
    }

    @Override
    public void copy(String text) {
        director.copy(text);
    }

    @Override
    public void tell(String notice) {
        director.tell(notice);
    }

    @Override
    public Words words() {
        return director.words();
    }

    @Override
    public Sounds sounds() {
        return director.sounds();
    }
}
