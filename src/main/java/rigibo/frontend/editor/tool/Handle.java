package rigibo.frontend.editor.tool;

import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;

import java.util.function.Function;

/**
 * Something to take hold of beside an item.
 *
 * @param kind what it is for
 * @param at where it is in the world, m
 * @param moved what becomes of the item when the handle is dragged to a point of the world
 */
record Handle(Kind kind, Point at, Function<Point, Item> moved) {

    enum Kind {
        SIZE,
        TURN
    }
}
