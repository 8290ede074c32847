package rigibo.frontend.scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The player: settings and progress. */
public interface Player {

    /** What the player has chosen. */
    Settings settings();

    /** Chooses anew. */
    void settings(Settings changed);

    /** What the player has done. */
    Progress progress();

    /** Keeps what was done by now. */
    void progress(Progress changed);

    /** Where solved runs are kept; nothing where none are. */
    Optional<Path> replays();

    /** Where levels that the player makes are kept; nothing where none are. */
    Optional<Path> levels();

    /** Where measurements and pictures are saved; nothing where none are. */
    Optional<Path> measurements();

    /** What the player should know about the files of all this, a sentence or two each. */
    List<String> notices(Words words);

    /** The player has read them; what still holds will be told again. */
    void forgetNotices();

    /** Adds a sentence or two to what the player should know. */
    void tell(String notice);
}
