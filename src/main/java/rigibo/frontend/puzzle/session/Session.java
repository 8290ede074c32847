package rigibo.frontend.puzzle.session;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Solution;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.replay.Proof;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Verdict;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.Canvas;

import java.util.Optional;

/**
 * A player's tries at one level: the running game, paused or slow, restarted or undone, and the
 * replay or solution shown in its place.
 */
public final class Session {

    /** Frames for which the end of a show stays on the screen. */
    private static final int CURTAIN = Steps.of(2);

    private final Level level;
    private final Accuracy accuracy;
    private final Poses poses = new Poses();
    private PuzzleGame own;
    private Optional<Playback> show = Optional.empty();
    private Optional<Proof> proof = Optional.empty();
    private Optional<BestRun> ghost = Optional.empty();
    private Hand hand = Hand.PLAYER;
    private int curtain;
    private Pace pace = Pace.FULL;
    private boolean isPaused;

    /** Frames since the last step: 0 in the frame that made one. */
    private int frame;

    public Session(Level level, Accuracy accuracy) {
        this.level = level;
        this.accuracy = accuracy;
        own = timed(new PuzzleGame(level, accuracy));
    }

    /** A session that only watches a recording and stops at its end. */
    public static Session watching(Recording recording) {
        Session session = new Session(recording.level(), recording.replay().accuracy());
        session.show(Hand.RECORDING, recording);
        return session;
    }

    /** Gives a game a clock, since the effects bar shows the time of a step. */
    private static PuzzleGame timed(PuzzleGame made) {
        made.pool().clock(System::nanoTime);
        return made;
    }

    /** Makes one frame of 1/60 s; returns whether the game advanced. */
    public boolean frame() {
        if (isPaused) {
            return false;
        }
        frame = (frame + 1) % pace.framesPerStep();
        boolean isDue = frame == 0;
        if (isDue) {
            poses.remember(game().pool());
            show.ifPresentOrElse(Playback::step, this::stepOwn);
            compare();
        }
        lowerCurtain();
        return isDue;
    }

    private void stepOwn() {
        own.step();
        leadGhost();
    }

    /** Puts a run beside the player's own game, or none. */
    public void ghost(Optional<BestRun> best) {
        ghost = best;
        leadGhost();
    }

    private void leadGhost() {
        ghost.ifPresent(run -> run.follow(own));
    }

    public boolean hasGhost() {
        return ghost.isPresent();
    }

    /** Draws the run beside the player's own game, if there is one. */
    public void drawGhost(Canvas canvas) {
        if (!isShowing()) {
            ghost.ifPresent(run -> run.draw(canvas, share()));
        }
    }

    private void lowerCurtain() {
        boolean isOver = isShowing() && game().outcome() != Outcome.RUNNING;
        if (isOver && hand != Hand.RECORDING && ++curtain > CURTAIN) {
            stopShow();
        }
    }

    /** The pose at which a body is drawn; in slow motion between two steps. */
    public Pose pose(RigidBody body) {
        return poses.of(body, share());
    }

    /** Share of the last step at which bodies are drawn. */
    private double share() {
        return (frame + 1.0) / pace.framesPerStep();
    }

    /** The pose of a body that the last step of a show deleted. */
    public Pose lastPose(RigidBody deleted) {
        return poses.last(deleted);
    }

    public void restart() {
        own = timed(new PuzzleGame(level, accuracy));
        leadGhost();
        endShow();
    }

    /**
     * Goes back to the state before the last click by playing again from the start. A few hundred
     * steps cost no more than a frame or two, and no stored state can differ. The level's own
     * effects are used, so that an experiment is undone with the click.
     *
     * @return whether there was a click to take back
     */
    public boolean undo() {
        Replay played = own.replay();
        if (isShowing() || played.acts().isEmpty()) {
            return false;
        }
        int step = played.acts().get(played.acts().size() - 1).step();
        Playback again = new Playback(level, played.withoutLast());
        again.stepTo(step);
        own = timed(again.game());
        leadGhost();
        toLastStep();
        return true;
    }

    /** Shows a solution from the level's start; afterwards the level starts again. */
    public void show(Solution solution) {
        show(Hand.SOLUTION, Replay.of(level, solution, accuracy));
    }

    /** Shows the finished game again; afterwards it is finished as before. */
    public void showAgain() {
        show(Hand.REPLAY, Recording.of(own));
    }

    private void show(Hand whose, Recording recording) {
        show(whose, recording.replay());
        proof = Optional.of(new Proof(recording));
        compare();
    }

    private void show(Hand whose, Replay replay) {
        endShow();
        Playback playback = new Playback(level, replay);
        timed(playback.game());
        show = Optional.of(playback);
        hand = whose;
    }

    private void compare() {
        show.ifPresent(playback -> proof.ifPresent(one -> one.observe(playback)));
    }

    /** Whether the game shown again runs as before; empty until it ends or differs. */
    public Optional<Verdict> verdict() {
        return proof.flatMap(Proof::verdict);
    }

    /** Ends the show. */
    public void stopShow() {
        if (hand == Hand.SOLUTION) {
            restart();
        } else {
            endShow();
        }
    }

    private void endShow() {
        show = Optional.empty();
        proof = Optional.empty();
        hand = Hand.PLAYER;
        curtain = 0;
        isPaused = false;
        toLastStep();
    }

    /** Shows the end of the last step until the next step. */
    private void toLastStep() {
        poses.forget();
        frame = pace.framesPerStep() - 1;
    }

    /** The game on the screen: the player's own, or the show in its place. */
    public PuzzleGame game() {
        return show.map(Playback::game).orElse(own);
    }

    /** The player's own game, shown or not. */
    public PuzzleGame own() {
        return own;
    }

    public Hand hand() {
        return hand;
    }

    /** The show in place of the player's own game. */
    public Optional<Playback> show() {
        return show;
    }

    public boolean isShowing() {
        return show.isPresent();
    }

    public Pace pace() {
        return pace;
    }

    public void pace(Pace next) {
        pace = next;
        frame = pace.framesPerStep() - 1;
    }

    public boolean isPaused() {
        return isPaused;
    }

    /** Pauses or resumes; a finished game cannot be paused, since that would hide its outcome. */
    public void togglePause() {
        isPaused = !isPaused && game().outcome() == Outcome.RUNNING;
    }
}
