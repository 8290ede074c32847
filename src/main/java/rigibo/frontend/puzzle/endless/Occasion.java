package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.record.Ledger;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.Optional;

/** Why a level is made, and what becomes of its results. */
public sealed interface Occasion permits Day, Endless {

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

    /**
     * The occasion that a level was made for: where seeds without a level were passed over, a later
     * one than was asked for.
     */
    Occasion of(Making.Made made);

    /** A level under the name that it has on this occasion. */
    Level named(Level level, Words words);

    /** The occasion to go on to, be this level solved or not; empty if this is the only one. */
    Optional<Occasion> next();

    /** Remembers that the player has come this far. */
    void reached(Director director);
}
