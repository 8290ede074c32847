package rigibo.frontend.puzzle.replay;

import rigibo.frontend.scene.Bundles;

import java.util.Locale;

/** The version of the game. */
final class GameVersion {

    private GameVersion() {}

    /** The version that the build states. */
    static String present() {
        return Bundles.of("rigibo.version", Locale.ROOT).getString("version");
    }
}
