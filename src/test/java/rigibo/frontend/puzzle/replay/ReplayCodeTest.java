package rigibo.frontend.puzzle.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Problems;
import rigibo.frontend.document.ShareCode;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.puzzle.rules.Replay;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

class ReplayCodeTest {

    private static final int APART = 30;

    private final Level level = LevelTexts.sound();

    /** A run with random states, which look like hashes. */
    private Recording run(int states, int clicks) {
        SplittableRandom random = new SplittableRandom(states);
        List<Checkpoint> checkpoints = new ArrayList<>();
        for (int i = 0; i < states; i++) {
            checkpoints.add(new Checkpoint(i * APART, random.nextLong()));
        }
        String target = level.solutions().get(0).clicks().get(0).target();
        List<Act> acts = new ArrayList<>();
        for (int i = 0; i < clicks; i++) {
            acts.add(new Act((int) ((states - 1L) * APART * i / clicks), target));
        }
        return new Recording(level, new Replay(level.hash(), acts, Accuracy.GAME), checkpoints);
    }

    private Recording read(String code) {
        String text = ShareCode.read(code, new Problems("code")).orElseThrow().text();
        LoadedReplay read = new ReplayLoader(List.of(level)).parse("code", text);
        assertThat(read.problems()).isEmpty();
        return read.recording().orElseThrow();
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 39, 40, 41, 79, 80, 81, 500, 7_201})
    void aRunOfAnyLengthKeepsItsClicksItsEndAndForty(int states) {
        Recording run = run(states, 12);
        Recording read = read(ReplayCode.of(run).orElseThrow());
        assertThat(read.replay()).isEqualTo(run.replay());
        assertThat(read.steps()).isEqualTo(run.steps());
        assertThat(run.checkpoints()).containsAll(read.checkpoints());
        assertThat(read.checkpoints()).hasSizeBetween(Math.min(states, 20), 40);
    }

    @ParameterizedTest
    @ValueSource(ints = {1_000, 5_000})
    void thousandsOfClicksHaveNoCode(int clicks) {
        assertThat(ReplayCode.of(run(7_201, clicks))).isEmpty();
    }
}
