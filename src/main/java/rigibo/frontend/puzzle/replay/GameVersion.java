package rigibo.frontend.puzzle.replay;

import java.util.ResourceBundle;

/** Which version of the game this is. */
final class GameVersion {

    private GameVersion() {}

    /** As the build states it. */
    static String present() {
        return ResourceBundle.getBundle("rigibo.version").getString("version");
    }
}
