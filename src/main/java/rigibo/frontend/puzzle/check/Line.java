package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Bookmarks;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The clicks of a game in their order.
 *
 * @param clicks all of them
 * @param begin the game just before the last of them; empty if it is to be played from the start
 */
record Line(List<Act> clicks, Optional<Bookmarks.Bookmark> begin) {

    Line {
        clicks = List.copyOf(clicks);
    }

    /** The step of the last click; 0 without one. */
    int last() {
        return clicks.isEmpty() ? 0 : clicks.get(clicks.size() - 1).step();
    }

    /** These clicks and one more. */
    List<Act> with(Act next) {
        List<Act> longer = new ArrayList<>(clicks);
        longer.add(next);
        return longer;
    }
}
