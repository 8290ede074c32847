package rigibo.frontend.scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Changes what is shown, and knows what holds in every scene. A change happens after the present
 * turn, in a window of its own.
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

    /** What the player has chosen. */
    Settings settings();

    /** Changes what the player has chosen, from now on and for the next time. */
    void settings(Settings changed);

    /** What the player has done so far. */
    Progress progress();

    /** Changes what the player has done, from now on and for the next time. */
    void progress(Progress changed);

    /** Where solved runs are kept; nothing where none are. */
    Optional<Path> replays();

    /** Where levels that the player makes are kept; nothing where none are. */
    Optional<Path> levels();

    /** What the player should know about the files of all this, a sentence or two each. */
    List<String> notices();

    /** The player has read them; what still holds will be told again. */
    void forgetNotices();

    /** Adds a sentence or two to what the player should know. */
    void tell(String notice);

    /** The game's words in the player's language. */
    Words words();

    /** What scenes are heard by. */
    Sounds sounds();
}
