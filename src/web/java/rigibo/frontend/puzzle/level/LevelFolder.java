package rigibo.frontend.puzzle.level;

import java.nio.file.Path;

/** The folder of the levels that the page has brought along. */
final class LevelFolder {

    private LevelFolder() {}

    static Path of(String resource) {
        return Path.of(System.getProperty("rigibo.home"), "levels");
    }
}
