package rigibo.frontend.puzzle.replay;

import rigibo.frontend.scene.Bundles;

import java.util.Locale;

/** The version of the game. */
final class GameVersion {

    private GameVersion() {}

    /** As the build states it. */
    static String present() {
        return Bundles.of("rigibo.version", Locale.ROOT).getString("version");
    }
}
