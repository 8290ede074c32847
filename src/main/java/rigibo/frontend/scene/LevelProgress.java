package rigibo.frontend.scene;

import java.util.OptionalInt;

/**
 * A player's progress in one level. A level that was altered since stays solved, so that the levels
 * it opened stay open, and its star stays found; clicks and failures refer to the level before the
 * change and are reset.
 *
 * @param levelHash of the level that was played, as its replays state it
 * @param isSolved whether it was ever solved
 * @param fewestClicks of all tries that solved it; none before the first
 * @param failures since it was last solved, 0 or more
 * @param hasStar whether its secret star was ever earned
 */
public record LevelProgress(
        long levelHash, boolean isSolved, OptionalInt fewestClicks, int failures, boolean hasStar) {

    public LevelProgress {
        if (fewestClicks.orElse(0) < 0) {
            throw new IllegalArgumentException(
                    "LevelProgress.fewestClicks must be 0 or more, was " + fewestClicks);
        }
        if (failures < 0) {
            throw new IllegalArgumentException(
                    "LevelProgress.failures must be 0 or more, was " + failures);
        }
        if (fewestClicks.isPresent() && !isSolved) {
            throw new IllegalArgumentException(
                    "LevelProgress.fewestClicks must be empty until it is solved, was "
                            + fewestClicks);
        }
        if (hasStar && !isSolved) {
            throw new IllegalArgumentException(
                    "LevelProgress.hasStar must be false until it is solved");
        }
    }

    /** Nothing yet. */
    static LevelProgress none(long levelHash) {
        return new LevelProgress(levelHash, false, OptionalInt.empty(), 0, false);
    }

    /** Returns this progress as it counts for a version of the level with a hash. */
    LevelProgress in(long hash) {
        return hash == levelHash
                ? this
                : new LevelProgress(hash, isSolved, OptionalInt.empty(), 0, hasStar);
    }

    LevelProgress solved(int clicks) {
        int fewest = Math.min(clicks, fewestClicks.orElse(clicks));
        return new LevelProgress(levelHash, true, OptionalInt.of(fewest), 0, hasStar);
    }

    LevelProgress failed() {
        int more = failures == Integer.MAX_VALUE ? failures : failures + 1;
        return new LevelProgress(levelHash, isSolved, fewestClicks, more, hasStar);
    }

    /** A copy whose star was found. */
    LevelProgress starred() {
        return new LevelProgress(levelHash, isSolved, fewestClicks, failures, true);
    }

    /** Merges progress made elsewhere; failures there do not count. */
    LevelProgress with(LevelProgress other) {
        LevelProgress known = other.in(levelHash);
        OptionalInt fewest =
                known.fewestClicks.isPresent()
                        ? solved(known.fewestClicks.getAsInt()).fewestClicks
                        : fewestClicks;
        return new LevelProgress(
                levelHash, isSolved || known.isSolved, fewest, failures, hasStar || known.hasStar);
    }
}
