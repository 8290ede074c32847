package rigibo.frontend.scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Changes the scene that is shown, and keeps what applies to every scene. A change happens after
 * the present turn, in a window of its own.
 */
public interface Director {

    /** Shows another scene. */
    void show(Scene scene);

    /** Goes back to the main menu. */
    void showMenu();

    /** Goes back to the list of levels. */
    void showLevels();

    /** Ends the game. */
    void quit();

    /** Who plays, and what is remembered of it. */
    Player player();

    /** What the player has chosen. */
    default Settings settings() {
        return player().settings();
    }

    /** Changes what the player has chosen, from now on and for the next time. */
    void settings(Settings changed);

    /** What the player has done so far. */
    default Progress progress() {
        return player().progress();
    }

    /** Changes what the player has done, from now on and for the next time. */
    default void progress(Progress changed) {
        player().progress(changed);
    }

    /** Where solved runs are kept; nothing where none are. */
    default Optional<Path> replays() {
        return player().replays();
    }

    /** Where levels that the player makes are kept; nothing where none are. */
    default Optional<Path> levels() {
        return player().levels();
    }

    /** What the player should know about the files of all this, a sentence or two each. */
    default List<String> notices() {
        return player().notices(words());
    }

    /** The player has read them; what still holds will be told again. */
    default void forgetNotices() {
        player().forgetNotices();
    }

    /** Adds a sentence or two to what the player should know. */
    default void tell(String notice) {
        player().tell(notice);
    }

    /** The game's words in the player's language. */
    Words words();

    /** What scenes are heard by. */
    Sounds sounds();
}
