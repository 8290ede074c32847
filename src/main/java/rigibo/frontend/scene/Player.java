package rigibo.frontend.scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The player: settings and progress. */
public interface Player {

    /** The player's settings. */
    Settings settings();

    /** Chooses anew. */
    void settings(Settings changed);

    /** The player's progress. */
    Progress progress();

    /** Replaces the progress. */
    void progress(Progress changed);

    /** Where solved runs are kept; nothing where none are. */
    Optional<Path> replays();

    /** Where levels that the player makes are kept; nothing where none are. */
    Optional<Path> levels();

    /** Where measurements and pictures are saved; nothing where none are. */
    Optional<Path> measurements();

    /** Notices about the player's files, a sentence or two each. */
    List<String> notices(Words words);

    /** The player has read them; what still holds will be told again. */
    void forgetNotices();

    /** Adds a sentence or two to what the player should know. */
    void tell(String notice);
}
