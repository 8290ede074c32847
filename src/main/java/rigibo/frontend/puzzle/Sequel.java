package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** What a player may go on to after a level. */
interface Sequel {

    /** Makes the scene to go on to; empty after the last level. */
    Optional<Supplier<Scene>> next();

    /** The level's window is gone: what was being prepared is not needed any more. */
    default void close() {}

    /** The level after one of several; nothing after the last. */
    static Sequel of(Director director, List<Level> levels, int number) {
        Optional<Supplier<Scene>> next =
                number + 1 < levels.size()
                        ? Optional.of(() -> new PuzzleScene(director, levels, number + 1))
                        : Optional.empty();
        return () -> next;
    }
}
