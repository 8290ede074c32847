package rigibo.frontend.puzzle.replay;

import rigibo.frontend.document.ShareCode;
import rigibo.frontend.puzzle.rules.Checkpoint;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Writes a recording as a code to be shared. */
public final class ReplayCode {

    /**
     * Most states in a code, of twenty bytes each, which cannot be compressed; the rest of its
     * letters is for the clicks.
     */
    private static final int MOST_STATES = 40;

    private ReplayCode() {}

    /** The code; empty if too many clicks would make it too long. */
    public static Optional<String> of(Recording recording) {
        Recording thinned =
                new Recording(recording.level(), recording.replay(), thinned(recording));
        return ShareCode.of(ShareCode.Kind.REPLAY, ReplayText.document(thinned));
    }

    /**
     * States at equal distances, the last one included, which shows whether the whole run was the
     * same.
     */
    private static List<Checkpoint> thinned(Recording recording) {
        List<Checkpoint> all = recording.checkpoints();
        int stride = (all.size() + MOST_STATES - 1) / MOST_STATES;
        List<Checkpoint> some = new ArrayList<>();
        for (int i = (all.size() - 1) % stride; i < all.size(); i += stride) {
            some.add(all.get(i));
        }
        return some;
    }
}
