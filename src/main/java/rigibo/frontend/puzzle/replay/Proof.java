package rigibo.frontend.puzzle.replay;

import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.util.List;
import java.util.Optional;

/** Plays a recording again, step by step, and compares each state that was kept. */
public final class Proof {

    private final Playback playback;
    private final List<Checkpoint> recorded;
    private int next;
    private Optional<Verdict> verdict = Optional.empty();

    /** A playback at its start. */
    public Proof(Recording recording) {
        playback = new Playback(recording.level(), recording.replay());
        recorded = recording.checkpoints();
        compare();
    }

    /** The verdict of a recording, after playing it to its end. */
    public static Verdict of(Recording recording) {
        Proof proof = new Proof(recording);
        while (proof.verdict.isEmpty()) {
            proof.step();
        }
        return proof.verdict.get();
    }

    /** Advances by 1/60 s; after the verdict it only goes on moving. */
    public void step() {
        playback.step();
        if (verdict.isEmpty()) {
            verdict = playback.refusal().map(r -> new Verdict.Refused(r.deletion(), r.result()));
            compare();
        }
    }

    private void compare() {
        if (verdict.isPresent() || recorded.get(next).step() != playback.game().steps()) {
            return;
        }
        Checkpoint expected = recorded.get(next);
        long found = playback.game().pool().stateHash();
        if (found != expected.hash()) {
            int lastSame = next == 0 ? -1 : recorded.get(next - 1).step();
            verdict = Optional.of(new Verdict.Diverged(lastSame, expected, found));
        } else if (++next == recorded.size()) {
            verdict = Optional.of(new Verdict.Same(recorded.size(), expected.step()));
        }
    }

    /** The game as it stands. */
    public PuzzleGame game() {
        return playback.game();
    }

    /** Nothing as long as all is the same and not at its end. */
    public Optional<Verdict> verdict() {
        return verdict;
    }
}
