package rigibo.frontend.display;

import rigibo.frontend.scene.Key;

import java.nio.file.Path;

/** A way of the tour from one scene to another, as a player would take it. */
public sealed interface Move {

    /**
     * Clicks a button, as soon as there is one of that name.
     *
     * @param key of the name in the bundles
     */
    record Click(String key) implements Move {}

    /** Presses the first key of a command. */
    record Press(Key key) implements Move {}

    /** Drops a file on the window. */
    record Drop(Path file) implements Move {}

    /** Lets the scene play itself to its end. */
    record Watch() implements Move {}
}
