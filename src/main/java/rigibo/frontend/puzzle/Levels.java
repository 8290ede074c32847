package rigibo.frontend.puzzle;

import org.tinylog.Logger;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.endless.Day;
import rigibo.frontend.puzzle.endless.Endless;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.picture.LevelPicture;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.nio.file.Path;
import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The levels as scenes: those of the game, and one opened from a file. */
public final class Levels {

    private Levels() {}

    /** An entry for each level of the game that can be played, in the order of their files. */
    public static List<SceneEntry> entries() {
        List<Placed> placed = OfTheGame.LEVELS;
        List<Level> levels = all();
        List<SceneEntry> entries = new ArrayList<>();
        for (int i = 0; i < levels.size(); i++) {
            entries.add(entry(levels, i, placed.get(i).world()));
        }
        return entries;
    }

    /** An entry for each of a player's levels, each of which leads to the next. */
    static List<SceneEntry> own(List<Level> levels) {
        return IntStream.range(0, levels.size())
                .mapToObj(number -> entry(levels, number, SceneEntry.Challenge.OWN))
                .toList();
    }

    /** Entries that lead to levels made by chance: the level of the day and the endless levels. */
    public static List<SceneEntry> made() {
        return List.of(
                SceneEntry.of(
                        "daily",
                        director -> new MadeLevelScene(director, Day.of(Clock.systemUTC()))),
                endless());
    }

    /** Leads to the player's next endless level. */
    public static SceneEntry endless() {
        return SceneEntry.of("endless", Levels::endless);
    }

    static Scene endless(Director director) {
        return new MadeLevelScene(director, new Endless(director.progress().endless()));
    }

    /** A page for each world with all its levels, called {@code world-1} and so on. */
    public static List<SceneEntry> sheets() {
        return OfTheGame.LEVELS.stream().map(Placed::world).distinct().map(Levels::sheet).toList();
    }

    private static SceneEntry sheet(int world) {
        List<Level> levels =
                OfTheGame.LEVELS.stream()
                        .filter(placed -> placed.world() == world)
                        .map(Placed::level)
                        .toList();
        return new SceneEntry(
                "world-" + world,
                words -> words.of("world." + world),
                words -> words.of("world." + world + ".words"),
                Optional.empty(),
                director -> new SheetScene(director, levels, world));
    }

    /** The levels of the game that can be played, in the order of their files. */
    public static List<Level> all() {
        return OfTheGame.LEVELS.stream().map(Placed::level).toList();
    }

    /** Whether a level is one of the game's own. */
    static boolean isOfTheGame(Level level) {
        return OfTheGame.LEVELS.stream().anyMatch(placed -> placed.level() == level);
    }

    /** Whether the player has solved a level. */
    static boolean isSolved(Director director, Level level) {
        return director.progress().of(level.id(), level.hash()).isSolved();
    }

    /** A level and the number of its world, from 1. */
    private record Placed(Level level, int world) {}

    /**
     * The levels, read when they are first asked for, since validating them takes longer than a
     * frame.
     */
    private static final class OfTheGame {

        static final List<Placed> LEVELS = read();

        private static List<Placed> read() {
            LevelLoader loader = new LevelLoader();
            return LevelShelf.files().stream().flatMap(file -> read(loader, file)).toList();
        }

        /**
         * Reports levels that cannot be played, which would otherwise be missing without a word.
         */
        private static Stream<Placed> read(LevelLoader loader, Path file) {
            LoadedLevel loaded = loader.load(file);
            loaded.problems().stream()
                    .filter(Problem::isError)
                    .forEach(problem -> Logger.warn("A level is left out: {}", problem));
            return loaded.level().stream().map(level -> new Placed(level, LevelShelf.world(file)));
        }
    }

    /**
     * The level of a file.
     *
     * @throws IllegalArgumentException with all that is wrong with the file, a line each
     */
    static Level level(Path file) {
        LoadedLevel loaded = new LevelLoader().load(file);
        return loaded.level()
                .orElseThrow(() -> new IllegalArgumentException(words(loaded.problems())));
    }

    private static SceneEntry entry(List<Level> levels, int number, int world) {
        Level level = levels.get(number);
        return new SceneEntry(
                level.id(),
                words -> level.title().in(words.locale()),
                words -> level.hint().in(words.locale()),
                Optional.of(
                        new SceneEntry.Challenge(
                                level.hash(),
                                world,
                                level.limits().par(),
                                new LevelPicture(level),
                                director -> Replays.best(director, level),
                                level.star().map(star -> words -> star.text().in(words.locale())))),
                director -> new PuzzleScene(director, levels, number));
    }

    static String words(List<Problem> problems) {
        StringBuilder lines = new StringBuilder("this cannot be opened:");
        problems.forEach(problem -> lines.append(System.lineSeparator()).append(problem));
        return lines.toString();
    }
}
