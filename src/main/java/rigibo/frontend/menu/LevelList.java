package rigibo.frontend.menu;

import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.SceneEntry;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The levels, and the player's progress in them.
 *
 * @param levels in their order
 * @param progress the player's
 */
record LevelList(List<SceneEntry> levels, Progress progress) {

    /** Number of levels that are open from the start. */
    private static final int OPEN_AT_FIRST = 3;

    /** Selects the levels among some entries. */
    static LevelList of(List<SceneEntry> entries, Progress progress) {
        return new LevelList(entries.stream().filter(SceneEntry::isLevel).toList(), progress);
    }

    private SceneEntry.Challenge challenge(int level) {
        return levels.get(level).challenge().orElseThrow();
    }

    LevelProgress done(int level) {
        return progress.of(levels.get(level).name(), challenge(level).hash());
    }

    boolean isSolved(int level) {
        return done(level).isSolved();
    }

    /** A level that was solved stays open, even if levels were added before it. */
    boolean isOpen(int level) {
        return level < OPEN_AT_FIRST || isSolved(level - 1) || isSolved(level);
    }

    Optional<Medal> medal(int level) {
        return challenge(level).medal(done(level));
    }

    /** Whether the level's secret star was found; of a level that has none any more it is gone. */
    boolean hasStar(int level) {
        return challenge(level).star().isPresent() && done(level).hasStar();
    }

    /** How many levels have a medal as their best. */
    long medals(Medal medal) {
        return IntStream.range(0, levels.size())
                .filter(level -> medal(level).filter(medal::equals).isPresent())
                .count();
    }

    /** How many secret stars were found. */
    long found() {
        return IntStream.range(0, levels.size()).filter(this::hasStar).count();
    }

    /** How many levels hide a star. */
    long hidden() {
        return IntStream.range(0, levels.size())
                .filter(level -> challenge(level).star().isPresent())
                .count();
    }

    long solved() {
        return IntStream.range(0, levels.size()).filter(this::isSolved).count();
    }

    boolean isComplete() {
        return !levels.isEmpty() && solved() == levels.size();
    }

    /**
     * The first open level that is not solved; otherwise the first without gold; otherwise the
     * first.
     */
    int next() {
        return IntStream.range(0, levels.size())
                .filter(level -> isOpen(level) && !isSolved(level))
                .findFirst()
                .orElseGet(this::firstWithoutGold);
    }

    private int firstWithoutGold() {
        return IntStream.range(0, levels.size())
                .filter(level -> isOpen(level) && medal(level).filter(Medal.GOLD::equals).isEmpty())
                .findFirst()
                .orElse(0);
    }
}
