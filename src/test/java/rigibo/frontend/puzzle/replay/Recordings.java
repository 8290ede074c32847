package rigibo.frontend.puzzle.replay;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;

/** Solved runs of the small valid level. */
public final class Recordings {

    private static final int MOST_STEPS = 1800;

    private Recordings() {}

    /** The run of its stored solution, at the game's accuracy. */
    public static Recording sound() {
        return of(LevelTexts.sound(), Accuracy.GAME);
    }

    /** The run of a level's first solution. */
    public static Recording of(Level level, Accuracy accuracy) {
        return Recording.of(level, level.solutions().get(0), accuracy, MOST_STEPS);
    }
}
