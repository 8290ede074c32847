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
     * A deletion that the rules did not allow; a replay of a real game has none.
     *
     * @param deletion the one
     * @param result why not
     */
    public record Refusal(Deletion deletion, ClickResult result) {}

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

    /** The game as it stands. */
    public PuzzleGame game() {
        return game;
    }

    /** Makes the deletions that are due, then one step. */
    public void step() {
        while (next < replay.deletions().size()
                && replay.deletions().get(next).step() <= game.steps()) {
            Deletion deletion = replay.deletions().get(next++);
            ClickResult result = game.delete(deletion.body());
            if (result != ClickResult.DELETED && refusal.isEmpty()) {
                refusal = Optional.of(new Refusal(deletion, result));
            }
        }
        game.step();
    }

    /** Goes on until so many steps are done. */
    public void stepTo(int steps) {
        while (game.steps() < steps) {
            step();
        }
    }

    /** The deletion to be made next; nothing when all were made. */
    public Optional<Deletion> upcoming() {
        return isDone() ? Optional.empty() : Optional.of(replay.deletions().get(next));
    }

    /** Whether every deletion was made. */
    public boolean isDone() {
        return next == replay.deletions().size();
    }

    /** The first deletion that was refused. */
    public Optional<Refusal> refusal() {
        return refusal;
    }
}
