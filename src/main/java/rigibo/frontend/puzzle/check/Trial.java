package rigibo.frontend.puzzle.check;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Loss;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.Optional;

/** Plays given clicks until the game ends. */
final class Trial {

    /** Steps after the last click within which a level must end. */
    private static final int PATIENCE = Steps.of(30);

    private final Playback playback;
    private final int deadline;

    /** A game at its start. */
    Trial(Level level, Replay replay) {
        this(new Playback(level, replay), replay);
    }

    /** A game at its start or in its middle. */
    Trial(Playback playback, Replay replay) {
        this.playback = playback;
        deadline = PATIENCE + lastClick(replay);
    }

    Verdict play() {
        while (!isOver()) {
            step();
        }
        return verdict();
    }

    void step() {
        playback.step();
    }

    PuzzleGame game() {
        return playback.game();
    }

    private static int lastClick(Replay replay) {
        int count = replay.acts().size();
        return count == 0 ? 0 : replay.acts().get(count - 1).step();
    }

    boolean isOver() {
        PuzzleGame game = playback.game();
        return game.outcome() != Outcome.RUNNING
                || playback.refusal().isPresent()
                || playback.isDone() && game.isStuck()
                || game.steps() >= deadline;
    }

    /** Whether every click was made and the game is not won. */
    boolean isUnsolved() {
        return playback.refusal().isEmpty() && playback.game().outcome() != Outcome.WON;
    }

    private Verdict verdict() {
        PuzzleGame game = playback.game();
        Verdict.End end = end();
        String why = end == Verdict.End.WON ? "" : why();
        int still = game.steps() - game.stillSteps();
        return new Verdict(end, game.steps(), still, why, game.hasStar());
    }

    private Verdict.End end() {
        PuzzleGame game = playback.game();
        if (playback.refusal().isPresent()) {
            return Verdict.End.REFUSED;
        }
        return switch (game.outcome()) {
            case WON -> Verdict.End.WON;
            case LOST -> Verdict.End.LOST;
            case RUNNING -> game.isStuck() ? Verdict.End.STUCK : Verdict.End.LOST;
        };
    }

    private String why() {
        Optional<Playback.Refusal> refusal = playback.refusal();
        if (refusal.isPresent()) {
            String target = "\"" + refusal.get().act().target() + "\"";
            return switch (refusal.get().result()) {
                case COOLING_DOWN -> "the click on " + target + " comes during the cooldown";
                case NOT_CLICKABLE -> target + " cannot be clicked";
                case NO_CLICKS_LEFT -> "no clicks are left for " + target;
                case NOTHING_THERE -> target + " is already gone";
                case OVER -> "the game was over before the click on " + target;
                case DONE -> "the click on " + target + " was made";
            };
        }
        PuzzleGame game = playback.game();
        if (game.loss().isPresent()) {
            Loss loss = game.loss().get();
            return "the ball is lost: " + loss.words();
        }
        return game.isStuck()
                ? "everything rests and the ball is not on the platform"
                : "nothing is decided " + Steps.seconds(PATIENCE) + " s after the last click";
    }
}
