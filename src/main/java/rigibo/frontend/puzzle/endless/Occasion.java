package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.record.Ledger;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.Optional;

/** The reason why a level is made, and the use of its results. */
public sealed interface Occasion permits Day, Endless {

    /** Seeds, of which the first that has a level is taken. */
    List<Long> seeds();

    /** The heading. */
    String title(Words words);

    /** The heading over the results so far. */
    String resultsTitle(Director director);

    /** The results so far, the best first, a line of columns each. */
    List<List<String>> results(Director director);

    /** The ledger for a level that was made for this occasion. */
    Ledger ledger(Director director, Level level);

    /**
     * The occasion of a level that was made: if seeds without a level were skipped, it is later
     * than the one asked for.
     */
    Occasion of(Making.Made made);

    /** A level with its name on this occasion. */
    Level named(Level level, Words words);

    /** The next occasion, whether this level is solved or not; empty if this is the only one. */
    Optional<Occasion> next();

    /** Stores that the player has come this far. */
    void reached(Director director);
}
