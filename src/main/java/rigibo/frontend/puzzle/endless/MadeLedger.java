package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.record.Ledger;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Progress;

import java.util.function.Consumer;

/**
 * Counts the tries at a level made by chance while it is played, and passes on a game that solves
 * it.
 */
final class MadeLedger implements Ledger {

    private final String id;
    private final long hash;
    private final Consumer<PuzzleGame> winner;
    private Progress tries = Progress.none();

    /**
     * A ledger without tries.
     *
     * @param winner receives a game that solved the level
     */
    MadeLedger(Level level, Consumer<PuzzleGame> winner) {
        id = level.id();
        hash = level.hash();
        this.winner = winner;
    }

    @Override
    public LevelProgress known() {
        return tries.of(id, hash);
    }

    @Override
    public void solved(PuzzleGame game) {
        tries = tries.solved(id, hash, game.clicks());
        winner.accept(game);
    }

    @Override
    public void failed() {
        tries = tries.failed(id, hash);
    }
}
