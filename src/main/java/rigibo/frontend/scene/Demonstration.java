package rigibo.frontend.scene;

import java.util.Optional;

/** How a scene plays itself: where the pointer goes and clicks, turn by turn. */
public interface Demonstration {

    /** The click to make before the next turn, in logical pixels; none on most turns. */
    Optional<Click> click();

    /** Whether there is nothing more to show. */
    boolean isOver();

    /** Whether what was to be shown came about: a level was won. */
    boolean hasSucceeded();

    /**
     * A click of the left button.
     *
     * @param x logical pixels from the left
     * @param y logical pixels from the top
     */
    record Click(double x, double y) {}
}
