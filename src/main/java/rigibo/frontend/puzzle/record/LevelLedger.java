package rigibo.frontend.puzzle.record;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Progress;

/** Keeps results in the player's progress, by the level's id. */
final class LevelLedger implements Ledger {

    private final Director director;
    private final String id;
    private final long hash;

    LevelLedger(Director director, Level level) {
        this.director = director;
        id = level.id();
        hash = level.hash();
    }

    @Override
    public LevelProgress known() {
        return director.progress().of(id, hash);
    }

    @Override
    public void solved(PuzzleGame game) {
        Progress solved = director.progress().solved(id, hash, game.clicks());
        director.progress(game.hasStar() ? solved.starred(id, hash) : solved);
    }

    @Override
    public void failed() {
        director.progress(director.progress().failed(id, hash));
    }
}
