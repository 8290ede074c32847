package rigibo.frontend.puzzle.replay;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Origin;

import java.util.List;

/**
 * A replay of a level that has to be made before it can be watched.
 *
 * @param name of the replay in messages
 * @param text of the replay
 * @param origin of its level
 */
public record UnmadeReplay(String name, String text, Origin origin) {

    /** The replay in its level, which was made meanwhile. */
    public LoadedReplay in(Level level) {
        return new ReplayLoader(List.of(level)).parse(name, text);
    }
}
