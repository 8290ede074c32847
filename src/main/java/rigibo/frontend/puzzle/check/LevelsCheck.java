package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LoadedLevel;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** {@code levels check}: one line per level, its problems below it, without a window. */
public final class LevelsCheck {

    private static final int ALL_SOUND = 0;
    private static final int SOME_BROKEN = 1;

    private final LevelLoader loader = new LevelLoader();
    private final Accuracy accuracy;
    private final PrintWriter out;

    /** A check that simulates at this accuracy and writes to {@code out}. */
    public LevelsCheck(Accuracy accuracy, PrintWriter out) {
        this.accuracy = accuracy;
        this.out = out;
    }

    /**
     * Checks files.
     *
     * @param files level files; none means all that come with the game
     * @return 0 when none has an error, else 1
     */
    public int run(List<Path> files) {
        List<Path> asked = files.isEmpty() ? LevelShelf.files() : files;
        int broken = 0;
        for (Path file : asked) {
            broken += isSound(file) ? 0 : 1;
        }
        out.println(asked.size() + " levels, " + broken + " with errors");
        out.flush();
        return broken == 0 ? ALL_SOUND : SOME_BROKEN;
    }

    private boolean isSound(Path file) {
        LoadedLevel loaded = loader.load(file);
        Optional<Level> level = loaded.level();
        LevelCheck check = new LevelCheck(accuracy);
        level.ifPresent(playable -> check.play(loaded, playable));
        out.println(file + ": " + (loaded.hasErrors() ? "ERRORS" : "ok") + check.summary(level));
        loaded.problems().forEach(out::println);
        out.flush();
        return !loaded.hasErrors();
    }
}
