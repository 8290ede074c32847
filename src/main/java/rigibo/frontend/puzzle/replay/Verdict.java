package rigibo.frontend.puzzle.replay;

import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.scene.Words;

/** Whether a replay ran as recorded. */
public sealed interface Verdict {

    /** Whether it does, to the last bit. */
    default boolean isSame() {
        return false;
    }

    /** In words. */
    String in(Words words);

    /**
     * Every state was the same to the last bit.
     *
     * @param states how many were compared
     * @param steps to the end
     */
    record Same(int states, int steps) implements Verdict {

        @Override
        public boolean isSame() {
            return true;
        }

        @Override
        public String in(Words words) {
            return words.of("replay.same", states, steps);
        }
    }

    /**
     * A state was another.
     *
     * @param lastSame the last step whose state was the same; negative when there was none
     * @param recorded the first that was not
     * @param found the hash in its place
     */
    record Diverged(int lastSame, Checkpoint recorded, long found) implements Verdict {

        @Override
        public String in(Words words) {
            String was = Hex.of(recorded.hash());
            String is = Hex.of(found);
            return lastSame < 0
                    ? words.of("replay.diverged-at-start", recorded.step(), was, is)
                    : words.of("replay.diverged", lastSame, recorded.step(), was, is);
        }
    }

    /**
     * A click was refused that had deleted something.
     *
     * @param act which
     * @param result why not now
     */
    record Refused(Act act, ClickResult result) implements Verdict {

        @Override
        public String in(Words words) {
            String why = words.of("replay.refused." + result.name());
            return words.of("replay.refused", act.target(), act.step(), why);
        }
    }
}
