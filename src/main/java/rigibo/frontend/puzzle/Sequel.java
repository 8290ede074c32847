package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.hud.Command;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** The player's next level after this one. */
interface Sequel {

    /** Makes the next scene; empty where nothing comes next. */
    Optional<Supplier<Scene>> next();

    /** The command that leads to what is next. */
    default Command onward() {
        return Command.NEXT;
    }

    /** The commands that leave the level, in order of increasing distance. */
    default List<Command> exits() {
        return List.of(Command.LEVELS, Command.MENU);
    }

    /** The level's window was closed: drops a level in preparation. */
    default void close() {}

    /**
     * The level after one of several. After the last come endless levels, once all of the game's
     * levels are solved; nothing before that.
     */
    static Sequel of(Director director, List<Level> levels, int number) {
        if (number + 1 < levels.size()) {
            return () -> Optional.of(() -> new PuzzleScene(director, levels, number + 1));
        }
        return Levels.isOfTheGame(levels.get(number)) ? endless(director, levels) : none();
    }

    private static Sequel endless(Director director, List<Level> before) {
        return new Sequel() {
            @Override
            public Optional<Supplier<Scene>> next() {
                return before.stream().allMatch(level -> Levels.isSolved(director, level))
                        ? Optional.of(() -> Levels.endless(director))
                        : Optional.empty();
            }

            @Override
            public Command onward() {
                return Command.ENDLESS;
            }
        };
    }

    /** Nothing comes after the level. */
    static Sequel none() {
        return Optional::empty;
    }

    /** The sequel of a draft that is tried out: every way leads back to the editor. */
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
