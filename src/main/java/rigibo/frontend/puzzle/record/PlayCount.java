package rigibo.frontend.puzzle.record;

import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Totals;

import java.util.Optional;

/**
 * Counts what a player does in a level, as it happens, so that what is taken back and played again
 * is counted as what was done.
 */
final class PlayCount {

    private Optional<PuzzleGame> seen = Optional.empty();
    private int steps;
    private int clicks;
    private Totals uncounted = Totals.NONE;

    /** Looks at the player's own game, once a turn until it is over. */
    void observe(PuzzleGame game) {
        if (seen.filter(game::equals).isPresent()) {
            Totals more = new Totals(0, game.clicks() - clicks, game.steps() - steps);
            uncounted = uncounted.plus(more);
        }
        seen = Optional.of(game);
        steps = game.steps();
        clicks = game.clicks();
    }

    /** A try has ended, or was left after a click. */
    void ended() {
        uncounted = uncounted.plus(new Totals(1, 0, 0));
    }

    /** What was counted since the last time; it is counted anew from here. */
    Totals taken() {
        Totals taken = uncounted;
        uncounted = Totals.NONE;
        return taken;
    }
}
