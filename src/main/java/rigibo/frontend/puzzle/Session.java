package rigibo.frontend.puzzle;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Replay;

/** A player's tries at one level: the running game, paused or slow, started anew or taken back. */
final class Session {

    private final Level level;
    private final Accuracy accuracy;
    private PuzzleGame game;
    private Pace pace = Pace.FULL;
    private boolean isPaused;
    private int frame;

    Session(Level level, Accuracy accuracy) {
        this.level = level;
        this.accuracy = accuracy;
        game = timed(new PuzzleGame(level, accuracy));
    }

    /** The effects bar tells how long a step takes. */
    private static PuzzleGame timed(PuzzleGame made) {
        made.pool().clock(System::nanoTime);
        return made;
    }

    /** One frame of 1/60 s; whether it advanced the game. */
    boolean frame() {
        frame++;
        boolean isDue = !isPaused && frame % pace.framesPerStep() == 0;
        if (isDue) {
            game.step();
        }
        return isDue;
    }

    /** How far the picture is between the last step and the next, 0 to 1. */
    double betweenSteps() {
        return frame % pace.framesPerStep() / (double) pace.framesPerStep();
    }

    void restart() {
        game = timed(new PuzzleGame(level, accuracy));
        isPaused = false;
    }

    /**
     * Back to just before the last click, by playing again from the start: a few hundred steps cost
     * less than a frame or two, and nothing has to be kept that could differ. Played again are the
     * level's own effects, so that an experiment is taken back with the click.
     *
     * @return whether there was a click to take back
     */
    boolean undo() {
        Replay played = game.replay();
        if (played.deletions().isEmpty()) {
            return false;
        }
        int step = played.deletions().get(played.deletions().size() - 1).step();
        Playback again = new Playback(level, played.withoutLast());
        again.stepTo(step);
        game = timed(again.game());
        return true;
    }

    PuzzleGame game() {
        return game;
    }

    Pace pace() {
        return pace;
    }

    void pace(Pace next) {
        pace = next;
    }

    boolean isPaused() {
        return isPaused;
    }

    /** Pausing a game that is over would only hide why. */
    void togglePause() {
        isPaused = !isPaused && game.outcome() == Outcome.RUNNING;
    }
}
