package rigibo.web.build;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.ReplayShelf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The stored solutions of all levels, played on the JVM and recorded like a player's runs. */
final class Recorded {

    private Recorded() {}

    /** Most steps of a solution: five minutes. */
    private static final int MOST_STEPS = 5 * 60 * 60;

    /** Writes the best run of each level like the game; returns the folder. */
    static Path runs() throws IOException {
        Path folder = Files.createTempDirectory("rigibo-runs");
        LevelLoader loader = new LevelLoader();
        for (Path file : LevelShelf.files()) {
            Level level = loader.load(file).level().orElseThrow();
            Solution solution = level.solutions().get(0);
            ReplayShelf shelf = new ReplayShelf(folder, level);
            shelf.keep(Recording.of(level, solution, Accuracy.GAME, MOST_STEPS));
            Files.delete(shelf.last());
        }
        return folder;
    }
}
