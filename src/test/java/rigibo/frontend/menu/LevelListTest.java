package rigibo.frontend.menu;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Progress;

import java.util.stream.IntStream;

class LevelListTest {

    private static final int COUNT = 6;
    private static final long HASH = Entries.HASH;

    private static LevelList after(Progress progress) {
        return LevelList.of(Entries.levels(COUNT), progress);
    }

    private static int[] open(LevelList levels) {
        return IntStream.range(0, COUNT).filter(levels::isOpen).toArray();
    }

    @Test
    void theFirstThreeAreOpenFromTheStart() {
        assertThat(open(after(Progress.none()))).containsExactly(0, 1, 2);
    }

    @Test
    void aLevelOpensWhenTheOneBeforeItIsSolved() {
        assertThat(open(after(Progress.none().solved("level2", HASH, 4))))
                .containsExactly(0, 1, 2, 3);
        assertThat(open(after(Progress.none().failed("level2", HASH)))).containsExactly(0, 1, 2);
    }

    @Test
    void whatWasSolvedOnceStaysOpen() {
        assertThat(open(after(Progress.none().solved("level4", HASH, 4))))
                .containsExactly(0, 1, 2, 4, 5);
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
