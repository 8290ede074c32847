package rigibo.frontend.puzzle.session;

import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Skin;

/**
 * The ghost of the player's best run: outlines of its balls at the present step of the game. The
 * run is simulated again from its clicks, so only those are stored.
 */
public final class BestRun {

    private final Recording run;
    private final Poses poses = new Poses();
    private Playback playback;

    /** A run at its start. */
    public BestRun(Recording run) {
        this.run = run;
        begin();
    }

    private void begin() {
        playback = new Playback(run.level(), run.replay());
        poses.forget();
    }

    /**
     * Advances the run to the step of a game, or starts it again if the game took a click back or
     * began anew. The run waits at its own end.
     */
    void follow(PuzzleGame game) {
        if (playback.game().steps() > game.steps()) {
            begin();
        }
        while (isBehind(game)) {
            poses.remember(playback.game().pool());
            playback.step();
        }
        if (playback.game().outcome() != Outcome.RUNNING) {
            poses.forget();
        }
    }

    private boolean isBehind(PuzzleGame game) {
        return playback.game().outcome() == Outcome.RUNNING
                && playback.game().steps() < game.steps();
    }

    /** The run up to the present step. */
    PuzzleGame game() {
        return playback.game();
    }

    /**
     * Draws the outlines of its balls.
     *
     * @param share of the way from the last step's beginning to its end, 0 to 1
     */
    void draw(Canvas canvas, double share) {
        for (RigidBody ball : playback.game().balls()) {
            Pose pose = poses.of(ball, share);
            canvas.body(
                    ball.shape(), pose.x(), pose.y(), pose.angle(), Skin.BALL, Canvas.Mood.GHOST);
        }
    }
}
