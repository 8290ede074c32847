package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Mutations;
import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.ProblemWords;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.stream.Stream;

/** Mutated levels give problems, never exceptions: a par of 1e308 once ended in a stack trace. */
class MutatedLevelFilesTest {

    private static final List<Words> LANGUAGES =
            Settings.LANGUAGES.stream().map(Words::new).toList();

    private final LevelLoader loader = new LevelLoader();

    @Test
    void noValueOfAnyPartIsWorseThanAProblem() {
        Mutations.of(LevelTexts.SOUND).forEach(this::assertReadOrTold);
    }

    /** Members that other levels have in addition. */
    static Stream<Arguments> more() {
        String box = "{\"type\": \"box\", \"w\": 0.5, \"h\": 4}";
        return Stream.of(
                Arguments.of(
                        "\"height\": 10,",
                        "\"height\": 10, \"water\": {\"level\": 1, \"density\": 9, \"drag\": 1},"),
                Arguments.of(
                        "\"platform\"",
                        "\"moreBalls\": [{\"x\": 6, \"y\": 5, \"radius\": 0.3}], \"platform\""),
                Arguments.of(box, "{\"type\": \"circle\", \"r\": 0.4}"),
                Arguments.of(box, "{\"type\": \"polygon\", \"points\": [[0, 0], [1, 0], [0, 1]]}"));
    }

    @ParameterizedTest
    @MethodSource("more")
    void noValueOfWhatOtherLevelsHaveIsWorseThanAProblem(String part, String other) {
        Mutations.someOf(LevelTexts.with(part, other)).forEach(this::assertReadOrTold);
    }

    private void assertReadOrTold(String mutated) {
        LoadedLevel loaded = loader.parse("a.json", mutated);
        String shown = mutated.substring(0, Math.min(1500, mutated.length()));
        assertThat(loaded.level().isPresent()).as(shown).isNotEqualTo(loaded.hasErrors());
        assertThat(loaded.problems())
                .extracting(Problem::toString)
                .as(shown)
                .allSatisfy(line -> assertThat(line).doesNotContain("\n").hasSizeLessThan(1000));
        loaded.problems().forEach(MutatedLevelFilesTest::assertToldToPlayers);
        loaded.level().ifPresent(MutatedLevelFilesTest::play);
    }

    private static void assertToldToPlayers(Problem problem) {
        for (Words words : LANGUAGES) {
            assertThat(ProblemWords.told(words, problem)).isNotBlank().doesNotContain("{0}", "@");
        }
    }

    private static void play(Level level) {
        PuzzleGame game = new PuzzleGame(level, Accuracy.DRAFT);
        game.step();
        assertThat(game.steps()).isEqualTo(1);
    }
}
