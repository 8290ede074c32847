package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.document.Mutations;
import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.rules.PuzzleGame;

/** A par of 1e308 ended in a stack trace. */
class MutatedLevelFilesTest {

    private final LevelLoader loader = new LevelLoader();

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''|''",
                "'\"height\": 10,'|'\"height\": 10, \"water\": {\"level\": 1, \"density\": 9,"
                        + " \"drag\": 1},'",
                "'\"platform\"'|'\"moreBalls\": [{\"x\": 6, \"y\": 5, \"radius\": 0.3}],"
                        + " \"platform\"'"
            })
    void noValueOfAnyPartIsWorseThanAProblem(String part, String more) {
        Mutations.of(LevelTexts.with(part, more)).forEach(this::assertReadOrTold);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"type\": \"circle\", \"r\": 0.4}",
                "{\"type\": \"polygon\", \"points\": [[0, 0], [1, 0], [0, 1]]}"
            })
    void noValueOfAnyShapeIsWorseThanAProblem(String shape) {
        String box = "{\"type\": \"box\", \"w\": 0.5, \"h\": 4}";
        Mutations.of(LevelTexts.with(box, shape)).forEach(this::assertReadOrTold);
    }

    private void assertReadOrTold(String mutated) {
        LoadedLevel loaded = loader.parse("a.json", mutated);
        String shown = mutated.substring(0, Math.min(1500, mutated.length()));
        assertThat(loaded.level().isPresent()).as(shown).isNotEqualTo(loaded.hasErrors());
        assertThat(loaded.problems())
                .extracting(Problem::toString)
                .as(shown)
                .allSatisfy(line -> assertThat(line).doesNotContain("\n").hasSizeLessThan(1000));
        loaded.level().ifPresent(MutatedLevelFilesTest::play);
    }

    private static void play(Level level) {
        PuzzleGame game = new PuzzleGame(level, Accuracy.DRAFT);
        game.step();
        assertThat(game.steps()).isEqualTo(1);
    }
}
