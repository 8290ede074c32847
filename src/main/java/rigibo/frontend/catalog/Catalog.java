package rigibo.frontend.catalog;

import rigibo.backend.effect.Effects;
import rigibo.frontend.demo.Demos;
import rigibo.frontend.editor.Editor;
import rigibo.frontend.gallery.Gallery;
import rigibo.frontend.laboratory.Laboratory;
import rigibo.frontend.menu.KeysScene;
import rigibo.frontend.menu.LevelsScene;
import rigibo.frontend.menu.MenuScene;
import rigibo.frontend.menu.OwnLevelsScene;
import rigibo.frontend.menu.SettingsScene;
import rigibo.frontend.puzzle.Films;
import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.OwnLevels;
import rigibo.frontend.puzzle.PlayerFiles;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Link;
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

    /** The gallery's exhibits, in its order. */
    public static List<SceneEntry> exhibits() {
        return Gallery.exhibits();
    }

    /** A page for each world of levels, which no menu leads to: for the tour. */
    public static List<SceneEntry> sheets() {
        return Levels.sheets();
    }

    /** Finds a scene by the name that the command line uses, among the gallery's exhibits too. */
    public static Optional<SceneEntry> find(String name) {
        return Stream.concat(entries().stream(), exhibits().stream())
                .filter(entry -> entry.name().equals(name))
                .findFirst();
    }

    /**
     * Opens the scene that the text of a link leads to and makes the choices that it states; empty
     * if there is no such scene. Choices that the scene does not know are ignored, and the player
     * is told.
     */
    public static Optional<Function<Director, Scene>> linked(String text) {
        Link link = Link.of(text);
        return find(link.scene()).map(entry -> director -> open(entry, link, director));
    }

    private static Scene open(SceneEntry entry, Link link, Director director) {
        Scene scene = entry.open().apply(director);
        if (!scene.follow(link)) {
            director.say(director.words().of("link.partly"));
        }
        return scene;
    }

    /**
     * Opens the editor with a level file, or with a new level if the file does not exist.
     *
     * @throws IllegalArgumentException when it is no level that can be edited, saying why
     */
    public static Function<Director, Scene> edit(Path file) {
        return Editor.of(file);
    }

    /** The effects that each demo declares, by its title, in the order of the menu. */
    public static Map<String, Effects> demoEffects() {
        return Demos.effects();
    }

    /**
     * The scene for files that the player names: a level to play, or a replay to watch, together
     * with its level if that is not one of the game's own.
     *
     * @throws IllegalArgumentException with all that is wrong with the files, a line each
     */
    public static Function<Director, Scene> files(List<Path> files) {
        return PlayerFiles.read(files).sound();
    }

    /**
     * The scene to be filmed, which plays by itself: a level of the game by its name, or a level or
     * replay by its file.
     *
     * @throws IllegalArgumentException when there is no such level, or with all that is wrong with
     *     the file
     */
    public static Function<Director, Scene> film(String levelOrFile) {
        return levelOrFile.endsWith(".json")
                ? PlayerFiles.read(List.of(Path.of(levelOrFile))).film()
                : Films.of(levelOrFile);
    }

    /** The scene for files that were dropped on a window; if they have errors, it shows them. */
    public static Scene dropped(Director director, List<Path> files) {
        return PlayerFiles.read(files).scene(director);
    }

    /**
     * The scene of a code that was pasted, or one that shows its errors; nothing of another text.
     */
    public static Optional<Scene> pasted(Director director, String text) {
        return PlayerFiles.pasted(director, text);
    }

    /** The main menu. */
    public static Scene menu(Director director) {
        return new MenuScene(director, entries(), Levels.endless());
    }

    /** The settings that a player may choose for all scenes. */
    public static Scene settings(Director director) {
        return new SettingsScene(director);
    }

    /** The page on which a player chooses keys. */
    public static Scene keys(Director director) {
        return new KeysScene(director);
    }

    /** The list of levels. */
    public static Scene levels(Director director) {
        List<SceneEntry> besides = new ArrayList<>(Levels.made());
        if (director.levels().filter(OwnLevels::areIn).isPresent()) {
            besides.add(SceneEntry.of("own", Catalog::own));
        }
        return new LevelsScene(director, entries(), besides);
    }

    /** The list of levels that the player made. */
    private static Scene own(Director director) {
        OwnLevels own = OwnLevels.in(director.levels().orElseThrow());
        return new OwnLevelsScene(director, own.entries(), own.broken(), Editor.entry());
    }
}
