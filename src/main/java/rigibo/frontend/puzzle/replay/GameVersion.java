package rigibo.frontend.puzzle.replay;

import java.util.ResourceBundle;

/** The version of the game. */
final class GameVersion {

    private GameVersion() {}

    /** As the build states it. */
    static String present() {
        return ResourceBundle.getBundle("rigibo.version").getString("version");
    }
}
