package rigibo.frontend.puzzle.replay;

import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.Playback;

import java.util.List;
import java.util.Optional;

/** Compares each recorded state with that of the replayed run. */
public final class Proof {

    private final List<Checkpoint> recorded;
    private int next;
    private Optional<Verdict> verdict = Optional.empty();

    /** A proof of a recording, before its playback begins. */
    public Proof(Recording recording) {
        recorded = recording.checkpoints();
    }

    /** The verdict of a recording, after playing it to its end. */
    public static Verdict of(Recording recording) {
        Playback playback = new Playback(recording.level(), recording.replay());
        Proof proof = new Proof(recording);
        proof.observe(playback);
        while (proof.verdict.isEmpty()) {
            playback.step();
            proof.observe(playback);
        }
        return proof.verdict.get();
    }

    /** Compares the state of a playback; called at its start and after each step. */
    public void observe(Playback playback) {
        if (verdict.isEmpty()) {
            verdict = playback.refusal().map(r -> new Verdict.Refused(r.act(), r.result()));
        }
        if (verdict.isEmpty() && recorded.get(next).step() == playback.game().steps()) {
            compare(recorded.get(next), playback.game().pool().stateHash());
        }
    }

    private void compare(Checkpoint expected, long found) {
        if (found != expected.hash()) {
            int lastSame = next == 0 ? -1 : recorded.get(next - 1).step();
            verdict = Optional.of(new Verdict.Diverged(lastSame, expected, found));
        } else if (++next == recorded.size()) {
            verdict = Optional.of(new Verdict.Same(recorded.size(), expected.step()));
        }
    }

    /** The verdict; empty before the end as long as all states agree. */
    public Optional<Verdict> verdict() {
        return verdict;
    }
}
