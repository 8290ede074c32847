package rigibo.frontend.puzzle.record;

import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.LevelProgress;

/** Where the results of a player's tries at a level are kept. */
public interface Ledger {

    /** What the player has done in the level so far. */
    LevelProgress known();

    /** Keeps a game that solved the level. */
    void solved(PuzzleGame game);

    /** Keeps that a try has failed. */
    void failed();
}
