package rigibo.frontend.puzzle.generate;

import rigibo.frontend.puzzle.check.Figures;
import rigibo.frontend.puzzle.level.Level;

import java.util.Locale;

/**
 * A level that was made from a seed.
 *
 * @param text as a level file
 * @param level read from the text
 * @param figures findings of the check
 * @param effort work of the search
 */
public record Generated(String text, Level level, Figures figures, Effort effort) {

    /**
     * The work of a search, counted and not timed, so that it is the same on every machine.
     *
     * @param plans tried
     * @param games played with them
     * @param steps of 1/60 s in these games
     */
    public record Effort(int plans, long games, long steps) {

        @Override
        public String toString() {
            return String.format(
                    Locale.ROOT, "found in plan %d by %d games of %d steps", plans, games, steps);
        }
    }
}
