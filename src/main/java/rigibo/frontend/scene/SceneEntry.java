package rigibo.frontend.scene;

import java.util.function.Function;

/**
 * A scene that can be chosen.
 *
 * @param name for the command line, in kebab-case
 * @param title for people
 * @param words what it is about, a short sentence
 * @param kind where the menu lists it
 * @param open makes the scene anew
 */
public record SceneEntry(
        String name, String title, String words, Kind kind, Function<Director, Scene> open) {

    /** Where the menu lists a scene. */
    public enum Kind {
        LEVEL,
        DEMO
    }
}
