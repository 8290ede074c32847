package rigibo.frontend.menu;

import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.SceneEntry;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The levels, world by world, and the player's progress in them. Levels count from 0 over all
 * worlds, worlds from 1; the player's own are in a world of their own, in which all are open.
 *
 * <p>Levels open by the number of levels solved, not one after the other. So moving or removing a
 * level closes no other, and nobody gets stuck at a level that is too hard.
 *
 * @param levels in their order
 * @param progress the player's
 */
record LevelList(List<SceneEntry> levels, Progress progress) {

    /** Number of levels of a world that are open as soon as the world is. */
    private static final int OPEN_AT_FIRST = 3;

    /** Number of levels that must be solved, in any worlds, to open each world after the first. */
    private static final int SOLVED_FOR_A_WORLD = 6;

    /** Selects the levels among some entries. */
    static LevelList of(List<SceneEntry> entries, Progress progress) {
        return new LevelList(entries.stream().filter(SceneEntry::isLevel).toList(), progress);
    }

    private SceneEntry.Challenge challenge(int level) {
        return levels.get(level).challenge().orElseThrow();
    }

    private String id(int level) {
        return levels.get(level).name();
    }

    LevelProgress done(int level) {
        return progress.of(id(level), challenge(level).hash());
    }

    boolean isSolved(int level) {
        return done(level).isSolved();
    }

    /** Number of worlds. */
    int worlds() {
        return IntStream.range(0, levels.size()).map(this::world).max().orElse(0);
    }

    /** The world of a level. */
    int world(int level) {
        return challenge(level).world();
    }

    /** The levels of a world. */
    List<Integer> of(int world) {
        return IntStream.range(0, levels.size())
                .filter(level -> world(level) == world)
                .boxed()
                .toList();
    }

    /** Place of a level in its world, from 0. */
    int place(int level) {
        return of(world(level)).indexOf(level);
    }

    /** Number of levels to solve, in any worlds, that open a world. */
    int opens(int world) {
        return (world - 1) * SOLVED_FOR_A_WORLD;
    }

    boolean isWorldOpen(int world) {
        return solved() >= opens(world);
    }

    /** Number of levels of its world to solve that open a level, once the world is open. */
    int opensWithin(int level) {
        return world(level) == SceneEntry.Challenge.OWN
                ? 0
                : Math.max(0, place(level) - OPEN_AT_FIRST + 1);
    }

    /** A level that was open once stays open. */
    boolean isOpen(int level) {
        return isWorldOpen(world(level)) && solved(world(level)) >= opensWithin(level)
                || progress.levels().containsKey(id(level))
                || FormerOrder.opened(id(level), progress);
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

    /** Number of levels of a world that are solved. */
    long solved(int world) {
        return of(world).stream().filter(this::isSolved).count();
    }

    /** Number of medals of a kind that were won in a world. */
    long medals(int world, Medal medal) {
        return of(world).stream()
                .filter(level -> medal(level).filter(medal::equals).isPresent())
                .count();
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
