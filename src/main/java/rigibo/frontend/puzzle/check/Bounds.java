package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Level;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;

/**
 * Bounds of the figures of a level of the game, by its place in its world: the first three levels
 * teach, the others are puzzles that luck does not solve. A figure out of bounds is reported but is
 * no error: it asks for a second look, not for another level.
 */
final class Bounds {

    /** Place of the first level that is a puzzle, from 1. */
    private static final int FIRST_PUZZLE = 4;

    /** Place of the first level of those that end a world. */
    private static final int FIRST_OF_THE_END = 9;

    private static final int LEAST_PAR = 2;

    /** Largest share of orders and times that may win, at the start and at the end of a world. */
    private static final double MOST_WINS = 0.30;

    private static final double MOST_WINS_AT_THE_END = 0.05;

    private static final double PERCENT = 100;

    private Bounds() {}

    /**
     * The figures out of bounds, a line each.
     *
     * @param place of the level in its world, from 1; empty for a level that is not of the game
     * @param wins number of won games of par clicks
     * @param misleads whether something looks right and loses
     */
    static List<String> told(OptionalInt place, Level level, Share wins, boolean misleads) {
        List<String> told = new ArrayList<>();
        int at = place.orElse(0);
        if (at < FIRST_PUZZLE) {
            return told;
        }
        if (level.limits().par() < LEAST_PAR) {
            told.add("out of bounds: par is less than " + LEAST_PAR);
        }
        double most = at < FIRST_OF_THE_END ? MOST_WINS : MOST_WINS_AT_THE_END;
        if (wins.least() > most) {
            told.add(
                    String.format(
                            Locale.ROOT,
                            "out of bounds: more than %.0f %% of orders and times win",
                            PERCENT * most));
        }
        if (!misleads) {
            told.add("out of bounds: nothing misleads");
        }
        return told;
    }
}
