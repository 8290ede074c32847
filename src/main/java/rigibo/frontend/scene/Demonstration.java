package rigibo.frontend.scene;

import java.util.Optional;

/** Lets a scene play itself: the moves and clicks of the pointer, turn by turn. */
public interface Demonstration {

    /** Where the pointer goes before the next turn; asked once each turn, before key and click. */
    default Optional<Click> pointer() {
        return Optional.empty();
    }

    /** The key to press before the next turn; none on most turns. */
    default Optional<Key> key() {
        return Optional.empty();
    }

    /** The click to make before the next turn, in logical pixels; none on most turns. */
    Optional<Click> click();

    /** Name of the picture to be saved after this turn; empty on most turns. */
    default Optional<String> picture() {
        return Optional.empty();
    }

    /** Whether everything has been shown. */
    boolean isOver();

    /** Whether it succeeded: for instance, whether the level was won. */
    boolean hasSucceeded();

    /**
     * A place of the pointer, or a click of its left button.
     *
     * @param x logical pixels from the left
     * @param y logical pixels from the top
     */
    record Click(double x, double y) {}
}
