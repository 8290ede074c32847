package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Key;

import java.util.List;

/** The action of the pointer on the draft. Points are in the world, m. */
public interface Tool {

    /** The left button went down. */
    void pressed(Point at);

    /** The pointer moved, with the button held or not. */
    default void moved(Point at) {}

    /** The left button went up, after it went down on the draft. */
    default void released(Point at) {}

    /** Cancels what the press of the button began; the tool is not told when the button goes up. */
    default void interrupted() {
        cancelled();
    }

    /** A key went down; returns whether the tool had a use for it. */
    default boolean keyPressed(Key key) {
        return false;
    }

    /** The keys that it has a use for at present. */
    default List<Key> keys() {
        return List.of();
    }

    /** Abandons unfinished work; returns whether there was any. */
    default boolean cancelled() {
        return false;
    }

    /** Draws unfinished work. */
    default void draw(Canvas canvas) {}
}
