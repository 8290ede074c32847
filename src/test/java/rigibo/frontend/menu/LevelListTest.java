package rigibo.frontend.menu;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.SceneEntry;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

class LevelListTest {

    private static final int COUNT = 6;
    private static final long HASH = Entries.HASH;

    private static LevelList after(Progress progress) {
        return LevelList.of(Entries.levels(COUNT), progress);
    }

    private static int[] open(LevelList levels) {
        return open(levels, COUNT);
    }

    private static int[] open(LevelList levels, int count) {
        return IntStream.range(0, count).filter(levels::isOpen).toArray();
    }

    @Test
    void theFirstThreeAreOpenFromTheStart() {
        assertThat(open(after(Progress.none()))).containsExactly(0, 1, 2);
    }

    @Test
    void everyLevelThatIsSolvedOpensOneMore() {
        assertThat(open(after(Progress.none().solved("level1", HASH, 4))))
                .containsExactly(0, 1, 2, 3);
        assertThat(open(after(Progress.none().failed("level2", HASH)))).containsExactly(0, 1, 2);
    }

    @Test
    void aWorldOpensWithLevelsSolvedInAnyWorld() {
        Progress progress = Progress.none();
        for (int level : new int[] {0, 1, 2, 5, 7}) {
            progress = progress.solved("level" + level, HASH, 4);
        }
        assertThat(worlds(progress).isWorldOpen(2)).isFalse();
        assertThat(worlds(progress).isOpen(Entries.WORLD)).isFalse();
        LevelList levels = worlds(progress.solved("level25", HASH, 4));
        assertThat(levels.isWorldOpen(2)).isTrue();
        assertThat(levels.isWorldOpen(3)).isFalse();
        assertThat(levels.isOpen(Entries.WORLD + 2)).isTrue();
        assertThat(levels.isOpen(Entries.WORLD + 3)).isFalse();
    }

    private static LevelList worlds(Progress progress) {
        return LevelList.of(Entries.levels(3 * Entries.WORLD), progress);
    }

    /** Levels were in one list, where "dominoes" came before "tower-of-ten". */
    @Test
    void whatWasOpenBeforeThereWereWorldsStaysOpen() {
        SceneEntry any = Entries.levels(1).get(0);
        List<SceneEntry> levels =
                Stream.of("a", "b", "c", "tower-of-ten", "snip")
                        .map(
                                id ->
                                        new SceneEntry(
                                                id,
                                                any.title(),
                                                any.words(),
                                                any.challenge(),
                                                any.open()))
                        .toList();
        Progress progress = Progress.none().solved("dominoes", HASH, 3);
        assertThat(open(LevelList.of(levels, progress), 5)).containsExactly(0, 1, 2, 3);
    }

    @Test
    void whatWasPlayedOnceStaysOpen() {
        assertThat(open(after(Progress.none().failed("level4", HASH)))).containsExactly(0, 1, 2, 4);
    }

    @Test
    void aChangedLevelKeepsWhatItOpenedButNotItsMedal() {
        LevelList levels = after(Progress.none().solved("level2", HASH + 1, 2));
        assertThat(open(levels)).containsExactly(0, 1, 2, 3);
        assertThat(levels.isSolved(2)).isTrue();
        assertThat(levels.medal(2)).isEmpty();
    }

    @Test
    void medalsGoByTheFewestClicks() {
        Progress progress =
                Progress.none()
                        .solved("level0", HASH, Entries.PAR)
                        .solved("level1", HASH, Entries.PAR + 1)
                        .solved("level2", HASH, Entries.PAR + 5);
        LevelList levels = after(progress);
        assertThat(levels.medal(0)).hasValue(Medal.GOLD);
        assertThat(levels.medal(1)).hasValue(Medal.SILVER);
        assertThat(levels.medal(2)).hasValue(Medal.BRONZE);
        assertThat(levels.medal(3)).isEmpty();
    }

    @Test
    void goesOnWithTheFirstUnsolvedThenWithTheFirstWithoutGold() {
        assertThat(after(Progress.none()).next()).isZero();
        Progress progress = Progress.none().solved("level0", HASH, 1).solved("level2", HASH, 1);
        assertThat(after(progress).next()).isEqualTo(1);
        for (int i = 0; i < COUNT; i++) {
            progress = progress.solved("level" + i, HASH, i == 4 ? Entries.PAR + 1 : Entries.PAR);
        }
        assertThat(after(progress).next()).isEqualTo(4);
        assertThat(after(progress.solved("level4", HASH, 1)).next()).isZero();
    }
}
