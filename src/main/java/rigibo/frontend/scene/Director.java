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

    /** Ends the game, where it can be ended from within. */
    void quit();

    /** Whether the game can be ended from within: a page is left by closing it. */
    default boolean canQuit() {
        return true;
    }

    /** The player's settings and progress. */
    Player player();

    /** The player's settings. */
    default Settings settings() {
        return player().settings();
    }

    /** Changes the player's settings, now and for the next time. */
    void settings(Settings changed);

    /** The player's progress. */
    default Progress progress() {
        return player().progress();
    }

    /** Changes the player's progress, now and for the next time. */
    default void progress(Progress changed) {
        player().progress(changed);
    }

    /** The folder of solved runs; empty if none are kept. */
    default Optional<Path> replays() {
        return player().replays();
    }

    /** The folder of the player's own levels; empty if none are kept. */
    default Optional<Path> levels() {
        return player().levels();
    }

    /** The folder of the player's measurements; empty if none are kept. */
    default Optional<Path> measurements() {
        return player().measurements();
    }

    /** Messages to the player about these files, a sentence or two each. */
    default List<String> notices() {
        return player().notices(words());
    }

    /** Marks the messages as read; those that still hold will be shown again. */
    default void forgetNotices() {
        player().forgetNotices();
    }

    /** Shows a few words for a moment. */
    default void say(String words) {}

    /** Writes what the window shows next into a PNG file; says so if that fails. */
    default void savePicture(Path file) {}

    /** Puts a text on the clipboard, and says so. */
    default void copy(String text) {}

    /** Whether the scene that is shown has an address, which players can share. */
    default boolean hasAddress() {
        return false;
    }

    /** Shares the address of the scene that is shown, by the system's own means. */
    default void share() {}

    /** Opens the level or replay whose code is on the clipboard, if there is one. */
    default void paste() {}

    /**
     * Whether files are handed over to the player, who could not find those that the game keeps.
     */
    default boolean handsOver() {
        return false;
    }

    /** Hands a text over as a file. */
    default void handOver(String name, String text) {}

    /** Adds a message to the player, a sentence or two. */
    default void tell(String notice) {
        player().tell(notice);
    }

    /** The game's words in the player's language. */
    Words words();

    /** The sounds that scenes report to. */
    Sounds sounds();
}
