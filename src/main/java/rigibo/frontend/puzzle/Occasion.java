package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.List;

/** Why a level is made, and what becomes of its results. */
sealed interface Occasion permits Day, Endless {

    /** Seeds of which the first that has a level is taken. */
    List<Long> seeds();

    /** A heading. */
    String title(Words words);

    /** A heading over the results so far. */
    String resultsTitle(Director director);

    /** The results so far, best shown first, a line of columns each. */
    List<List<String>> results(Director director);

    /** Where the results of a level that was made for it are kept. */
    Ledger ledger(Director director, Level level);

    /** The scene in which the level is played. */
    Scene play(Director director, Making.Made made);

    /** Whether there is another level to go on to without solving this one. */
    boolean hasOther();

    /** The scene of that other level. */
    Scene other(Director director);
}
