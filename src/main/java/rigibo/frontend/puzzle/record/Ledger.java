package rigibo.frontend.puzzle.record;

import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.LevelProgress;

/** The record of a player's results in a level. */
public interface Ledger {

    /** The player's results in the level so far. */
    LevelProgress known();

    /** Records a game that solved the level. */
    void solved(PuzzleGame game);

    /** Records a failed try. */
    void failed();
}
