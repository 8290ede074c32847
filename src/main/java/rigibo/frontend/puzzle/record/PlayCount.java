package rigibo.frontend.puzzle.record;

import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Totals;

import java.util.Optional;

/**
 * Counts a player's actions in a level as they happen, so that clicks taken back and made again all
 * count.
 */
final class PlayCount {

    private Optional<PuzzleGame> seen = Optional.empty();
    private int steps;
    private int clicks;
    private Totals uncounted = Totals.NONE;

    /** Counts the player's own game, once a turn until it is over. */
    void observe(PuzzleGame game) {
        if (seen.filter(game::equals).isPresent()) {
            Totals more = new Totals(0, game.clicks() - clicks, game.steps() - steps);
            uncounted = uncounted.plus(more);
        }
        seen = Optional.of(game);
        steps = game.steps();
        clicks = game.clicks();
    }

    /** Counts the end of a try, or its abandonment after a click. */
    void ended() {
        uncounted = uncounted.plus(new Totals(1, 0, 0));
    }

    /** Returns the counts since the last call, and starts again at 0. */
    Totals taken() {
        Totals taken = uncounted;
        uncounted = Totals.NONE;
        return taken;
    }
}
