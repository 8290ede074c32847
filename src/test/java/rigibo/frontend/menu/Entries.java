package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Entries of a menu whose scenes only have names. */
final class Entries {

    static final long HASH = 17;
    static final int PAR = 2;

    /** Levels of a world. */
    static final int WORLD = 10;

    private Entries() {}

    /** Levels of the ids level0, level1 … with titles that are longer than a card is wide. */
    static List<SceneEntry> levels(int count) {
        return IntStream.range(0, count).mapToObj(Entries::level).toList();
    }

    private static SceneEntry level(int number) {
        return new SceneEntry(
                "level" + number,
                words -> "A level of a very long title, " + number,
                words -> "hint",
                Optional.of(
                        new SceneEntry.Challenge(
                                HASH,
                                1 + number / WORLD,
                                PAR,
                                (canvas, x, y, width, height) ->
                                        canvas.frame(x, y, width, height, 0, Color.EDGE),
                                director -> kept(number),
                                Optional.of(words -> "The ball goes round " + number))),
                director -> new Named("level" + number));
    }

    /** A best run was kept for the first level. */
    private static Optional<Scene> kept(int number) {
        return number == 0 ? Optional.of(new Named("run of level0")) : Optional.empty();
    }

    /** The entries of levels made by chance. */
    static List<SceneEntry> made() {
        return Stream.of("daily", "endless")
                .map(name -> SceneEntry.of(name, director -> new Named(name)))
                .toList();
    }

    /** The main menu of some entries. */
    static MenuScene menu(Director director, List<SceneEntry> entries) {
        return new MenuScene(director, entries, made().get(1));
    }

    /** Some levels, and all else that the game has. */
    static List<SceneEntry> all(int levels) {
        List<SceneEntry> entries = new ArrayList<>(levels(levels));
        for (String name : List.of("crate", "wheel", "friction", "flood", "laboratory")) {
            entries.add(SceneEntry.of(name, director -> new Named(name)));
        }
        return entries;
    }

    /** A scene that only has a name. */
    record Named(String title) implements Scene {

        @Override
        public void step() {}

        @Override
        public void draw(Canvas canvas) {}
    }
}
