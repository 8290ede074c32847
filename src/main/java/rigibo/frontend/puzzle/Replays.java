package rigibo.frontend.puzzle;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.ReplayCode;
import rigibo.frontend.puzzle.replay.ReplayLoader;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Recorded runs from files, of the game's levels or of a given one. */
public final class Replays {

    private final ReplayLoader loader;

    private Replays(List<Level> levels) {
        loader = new ReplayLoader(levels);
    }

    /** Replays of the game's own levels. */
    public static Replays ofGame() {
        return new Replays(Levels.all());
    }

    /**
     * Replays of the level in a file.
     *
     * @throws IllegalArgumentException with all errors of the level, a line each
     */
    public static Replays of(Path level) {
        return new Replays(List.of(Levels.level(level)));
    }

    /**
     * Shows the player's best run of a level, or a message about runs that can no longer be played;
     * empty if none was kept.
     */
    static Optional<Scene> best(Director director, Level level) {
        return director.replays()
                .map(folder -> new ReplayShelf(folder, level))
                .flatMap(shelf -> watched(director, shelf).or(() -> told(director, shelf)));
    }

    private static Optional<Scene> watched(Director director, ReplayShelf shelf) {
        return shelf.watchable()
                .map(run -> new ReplayScene(director, run, ReplayScene.Audience.PLAYER));
    }

    private static Optional<Scene> told(Director director, ReplayShelf shelf) {
        List<Problem> told = shelf.ofOtherRevisions();
        return told.isEmpty() ? Optional.empty() : Optional.of(new ProblemsScene(director, told));
    }

    /** Puts a run on the clipboard, as a code. */
    static void copy(Director director, Recording run) {
        ReplayCode.of(run)
                .ifPresentOrElse(
                        director::copy,
                        () -> director.say(director.words().of("toast.run-too-long")));
    }

    /** Reads a replay file and reports all of its errors at once. */
    public LoadedReplay load(Path file) {
        return loader.load(file);
    }
}
