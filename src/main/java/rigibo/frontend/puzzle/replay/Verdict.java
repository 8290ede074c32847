package rigibo.frontend.puzzle.replay;

import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.scene.Words;

/** The result of comparing a replay with its recording. */
public sealed interface Verdict {

    /** Whether all states are the same, to the last bit. */
    default boolean isSame() {
        return false;
    }

    /** The verdict in words. */
    String in(Words words);

    /**
     * Every state was the same to the last bit.
     *
     * @param states number of states compared
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
     * A state was different.
     *
     * @param lastSame the last step with the same state; negative if there was none
     * @param recorded the first different one
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
     * A click was refused that had acted in the recording.
     *
     * @param act the click
     * @param result reason of the refusal
     */
    record Refused(Act act, ClickResult result) implements Verdict {

        @Override
        public String in(Words words) {
            String why = words.of("replay.refused." + result.name());
            return words.of("replay.refused", act.target(), act.step(), why);
        }
    }
}
