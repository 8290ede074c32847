package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.hud.Command;
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

    /** The commands that leave the level, the nearest place first and the farthest last. */
    default List<Command> exits() {
        return List.of(Command.LEVELS, Command.MENU);
    }

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

    /** Nothing comes after the level. */
    static Sequel none() {
        return Optional::empty;
    }

    /** A level that is tried out in the editor, to which every way leads back. */
    static Sequel backToTheEditor() {
        return new Sequel() {
            @Override
            public Optional<Supplier<Scene>> next() {
                return Optional.empty();
            }

            @Override
            public List<Command> exits() {
                return List.of(Command.EDITOR);
            }
        };
    }
}
