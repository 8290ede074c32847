package rigibo.frontend.catalog;

import rigibo.backend.effect.Effects;
import rigibo.frontend.demo.Demos;
import rigibo.frontend.editor.Editor;
import rigibo.frontend.gallery.Gallery;
import rigibo.frontend.laboratory.Laboratory;
import rigibo.frontend.menu.LevelsScene;
import rigibo.frontend.menu.MenuScene;
import rigibo.frontend.menu.SettingsScene;
import rigibo.frontend.puzzle.Films;
import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.PlayerFiles;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** Every scene that can be chosen. */
public final class Catalog {

    private Catalog() {}

    /** The scenes in the order of the menu. */
    public static List<SceneEntry> entries() {
        List<SceneEntry> entries = new ArrayList<>(Levels.entries());
        entries.addAll(Demos.entries());
        entries.add(Gallery.entry());
        entries.add(Laboratory.entry());
        entries.add(Editor.entry());
        return entries;
    }

    /** What hangs in the gallery, in its order. */
    public static List<SceneEntry> exhibits() {
        return Gallery.exhibits();
    }

    /** The scene of a name, for the command line; of the gallery's, too. */
    public static Optional<SceneEntry> find(String name) {
        return Stream.concat(entries().stream(), exhibits().stream())
                .filter(entry -> entry.name().equals(name))
                .findFirst();
    }

    /**
     * The editor with a level file, or with a new level where there is none.
     *
     * @throws IllegalArgumentException when it is no level that can be edited, saying why
     */
    public static Function<Director, Scene> edit(Path file) {
        return Editor.of(file);
    }

    /** What each demo declares, by its title, in the order of the menu. */
    public static Map<String, Effects> demoEffects() {
        return Demos.effects();
    }

    /**
     * The scene of files that the player names: a level to be played or a replay to be watched,
     * with its level where that is none of the game's own.
     *
     * @throws IllegalArgumentException with all that is wrong with the files, a line each
     */
    public static Function<Director, Scene> files(List<Path> files) {
        return PlayerFiles.read(files).sound();
    }

    /**
     * What is filmed: a level of the game by its name, or a level or replay by its file, as it
     * plays by itself.
     *
     * @throws IllegalArgumentException when there is no such level, or with all that is wrong with
     *     the file
     */
    public static Function<Director, Scene> film(String levelOrFile) {
        return levelOrFile.endsWith(".json")
                ? PlayerFiles.read(List.of(Path.of(levelOrFile))).film()
                : Films.of(levelOrFile);
    }

    /** The scene of files that were dropped on a window; what is wrong with them is shown. */
    public static Scene dropped(Director director, List<Path> files) {
        return PlayerFiles.read(files).scene(director);
    }

    /** The main menu. */
    public static Scene menu(Director director) {
        return new MenuScene(director, entries());
    }

    /** What a player may choose for every scene. */
    public static Scene settings(Director director) {
        return new SettingsScene(director);
    }

    /** The list of levels. */
    public static Scene levels(Director director) {
        return new LevelsScene(director, entries());
    }
}
