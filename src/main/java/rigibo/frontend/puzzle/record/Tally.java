package rigibo.frontend.puzzle.record;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Totals;

import java.io.IOException;
import java.util.Optional;

/** Reports the end of each try to a ledger; an experiment does not count. */
public final class Tally {

    /** Number of failures after which the hint is offered. */
    static final int PATIENCE = 3;

    private final Director director;
    private final Level level;
    private final Ledger ledger;
    private final Optional<ReplayShelf> shelf;
    private final PlayCount count = new PlayCount();

    private Tally(Director director, Level level, Ledger ledger, Optional<ReplayShelf> shelf) {
        this.director = director;
        this.level = level;
        this.ledger = ledger;
        this.shelf = shelf;
    }

    /** The tally of a permanent level, whose runs are kept. */
    public Tally(Director director, Level level) {
        this(
                director,
                level,
                new LevelLedger(director, level),
                director.replays().map(folder -> new ReplayShelf(folder, level)));
    }

    /** The tally of a level made by chance, of which no run is kept. */
    public Tally(Director director, Level level, Ledger ledger) {
        this(director, level, ledger, Optional.empty());
    }

    /** Counts the player's own game, once a turn while it is on the screen. */
    public void observe(PuzzleGame game) {
        count.observe(game);
    }

    /** Records a try that was won or lost. */
    public void ended(PuzzleGame game) {
        count.ended();
        keepCount(game);
        if (game.isSolved()) {
            ledger.solved(game);
            shelf.ifPresent(place -> keep(place, game));
        } else if (game.outcome() == Outcome.LOST) {
            failed(game);
        }
    }

    private void keep(ReplayShelf place, PuzzleGame game) {
        try {
            place.keep(Recording.of(game));
        } catch (IOException broken) {
            String why = broken.getMessage();
            director.tell(director.words().of("replay.not-kept", level.id(), why));
        }
    }

    /** Records an abandoned try: a failure, unless it had no click. */
    public void givenUp(PuzzleGame game) {
        if (isLeft(game)) {
            failed(game);
        }
        left(game);
    }

    /** Counts a try that ended by restarting or leaving the level; by itself that is no failure. */
    public void left(PuzzleGame game) {
        if (isLeft(game)) {
            count.ended();
        }
        keepCount(game);
    }

    private static boolean isLeft(PuzzleGame game) {
        return game.outcome() == Outcome.RUNNING && game.clicks() > 0;
    }

    /** Counts of an experiment, its time included, are dropped. */
    private void keepCount(PuzzleGame game) {
        Totals more = count.taken();
        if (!game.isExperiment() && !more.equals(Totals.NONE)) {
            director.progress(director.progress().played(more));
        }
    }

    private void failed(PuzzleGame game) {
        if (!game.isExperiment()) {
            ledger.failed();
        }
    }

    /** Whether a run was kept, though perhaps of another revision. */
    public boolean hasRun() {
        return shelf.filter(ReplayShelf::hasRun).isPresent();
    }

    /** The best kept run that can still be played; reads a file. */
    public Optional<Recording> best() {
        return shelf.flatMap(ReplayShelf::watchable);
    }

    /** Whether the player has found the level's star, in this try or before. */
    public boolean hasStar() {
        return ledger.known().hasStar();
    }

    /** Failures still missing before the hint is offered; 0 if it may be shown. */
    public int failuresToHint() {
        return Math.max(0, PATIENCE - ledger.known().failures());
    }
}
