package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;

import java.util.function.Function;

/**
 * A handle beside an item.
 *
 * @param kind its purpose
 * @param at its position in the world, m
 * @param moved the item that results when the handle is dragged to a point of the world
 */
record Handle(Kind kind, Point at, Function<Point, Item> moved) {

    enum Kind {
        SIZE,
        TURN,
        /** Where a driven body stops. */
        STOP
    }
}
