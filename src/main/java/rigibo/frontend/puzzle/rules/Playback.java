package rigibo.frontend.puzzle.rules;

import rigibo.frontend.puzzle.level.Level;

import java.util.Optional;

/** Plays a replay step by step. */
public final class Playback {

    private final Replay replay;
    private final PuzzleGame game;
    private int next;
    private Optional<Refusal> refusal = Optional.empty();

    /**
     * A click that the rules did not allow; a replay of a real game has none.
     *
     * @param act the click
     * @param result reason of the refusal
     */
    public record Refusal(Act act, ClickResult result) {}

    /**
     * A playback from the level's start.
     *
     * @throws IllegalArgumentException when the replay belongs to another level
     */
    public Playback(Level level, Replay replay) {
        if (replay.levelHash() != level.hash()) {
            throw new IllegalArgumentException(
                    "the replay belongs to another level than " + level.id());
        }
        this.replay = replay;
        game = new PuzzleGame(level, replay.accuracy());
    }

    /**
     * A playback from the middle of a game, whose clicks so far are the replay's first.
     *
     * @param begun the game, which goes on in this playback
     */
    public Playback(PuzzleGame begun, Replay replay) {
        this.replay = replay;
        game = begun;
        next = begun.clicks();
    }

    /** The game as it stands. */
    public PuzzleGame game() {
        return game;
    }

    /** Makes the clicks that are due, then one step. */
    public void step() {
        while (next < replay.acts().size() && replay.acts().get(next).step() <= game.steps()) {
            Act act = replay.acts().get(next++);
            ClickResult result = game.act(act.target());
            if (result != ClickResult.DONE && refusal.isEmpty()) {
                refusal = Optional.of(new Refusal(act, result));
            }
        }
        game.step();
    }

    /** Makes steps up to a number of them. */
    public void stepTo(int steps) {
        while (game.steps() < steps) {
            step();
        }
    }

    /** The next click; empty after the last one. */
    public Optional<Act> upcoming() {
        return isDone() ? Optional.empty() : Optional.of(replay.acts().get(next));
    }

    /** Whether every click was made. */
    public boolean isDone() {
        return next == replay.acts().size();
    }

    /** The first click that was refused. */
    public Optional<Refusal> refusal() {
        return refusal;
    }
}
