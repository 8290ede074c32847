package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.scene.SceneEntry;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * The levels that a player made, as scenes.
 *
 * @param entries the levels that can be played, in the order of their files; each leads to the next
 * @param broken number of files with errors
 */
public record OwnLevels(List<SceneEntry> entries, int broken) {

    /** Reads the level files of a folder. */
    public static OwnLevels in(Path folder) {
        LevelLoader loader = new LevelLoader();
        List<Path> files = LevelShelf.own(folder);
        List<Level> levels =
                files.stream()
                        .map(file -> loader.load(file).level())
                        .flatMap(Optional::stream)
                        .toList();
        return new OwnLevels(Levels.own(levels), files.size() - levels.size());
    }

    /** Whether a folder holds any. */
    public static boolean areIn(Path folder) {
        return !LevelShelf.own(folder).isEmpty();
    }
}
