package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.scene.accuracy.Preset;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;

/**
 * The command {@code levels check}: lists each level, the proved facts and the problems; needs no
 * window.
 */
public final class LevelsCheck {

    private static final int ALL_SOUND = 0;
    private static final int SOME_BROKEN = 1;

    private final LevelLoader loader = new LevelLoader();
    private final List<Preset> presets;
    private final PrintWriter out;

    /** A check that simulates at each of these accuracies and writes to {@code out}. */
    public LevelsCheck(List<Preset> presets, PrintWriter out) {
        this.presets = List.copyOf(presets);
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
        List<String> proved =
                loaded.level()
                        .map(
                                level ->
                                        LevelCheck.play(
                                                loaded,
                                                level,
                                                presets,
                                                LevelShelf.place(file),
                                                games -> {}))
                        .orElse(List.of());
        out.println(file + ": " + (loaded.hasErrors() ? "ERRORS" : "ok"));
        proved.forEach(line -> out.println("  " + line));
        loaded.problems().forEach(out::println);
        out.flush();
        return !loaded.hasErrors();
    }
}
