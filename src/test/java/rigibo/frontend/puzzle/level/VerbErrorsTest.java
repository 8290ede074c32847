package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.document.Problem;

import java.util.List;

/** What a level file says of clicks that it cannot mean. */
class VerbErrorsTest {

    private static List<String> problems(String text) {
        return new LevelLoader()
                .parse("a.json", text).problems().stream().map(Problem::toString).toList();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "'click': 'cut'; 'click': 'pull'; E124 a click cannot pull a rope",
                "'id': 'line', ; ; E125 what can be clicked needs an 'id'",
                "'id': 'line'; 'id': 'hook'; E101 joint id 'hook' is used twice (first at 13:12)",
                "'click': 'cut'; 'click': 'snip'; 'snip' is not one of cut, pull",
            })
    void aClickThatDoesNotFitIsTold(String part, String replacement, String told) {
        String text =
                VerbLevels.ROPE.replace(
                        part.replace('\'', '"').strip() + (part.endsWith(" ") ? " " : ""),
                        replacement == null ? "" : replacement.replace('\'', '"'));
        assertThat(text).isNotEqualTo(VerbLevels.ROPE);
        assertThat(problems(text)).anyMatch(line -> line.contains(told.replace('\'', '"')));
    }

    private static String solved(String click) {
        String text = VerbLevels.ROPE.stripTrailing();
        return text.substring(0, text.length() - 1)
                + ", \"solutions\": [{\"clicks\": ["
                + click
                + "]}]}";
    }

    @Test
    void aSolutionNamesBodiesAndJointsEachByTheirKind() {
        assertThat(problems(solved("{\"t\": 1, \"joint\": \"line\"}"))).isEmpty();
        assertThat(problems(solved("{\"t\": 1, \"joint\": \"hook\"}")))
                .anyMatch(line -> line.contains("E102 no joint has the id \"hook\""));
        assertThat(problems(solved("{\"t\": 1, \"body\": \"line\"}")))
                .anyMatch(line -> line.contains("E102 no body has the id \"line\""));
        assertThat(problems(solved("{\"t\": 1}")))
                .anyMatch(line -> line.contains("\"body\" is missing"));
        assertThat(problems(solved("{\"t\": 1, \"body\": \"hook\", \"joint\": \"line\"}")))
                .isNotEmpty();
    }

    /** Levels without verbs have the hash that they had, so that their replays still play. */
    @Test
    void aClickOnAJointIsPartOfTheHashAndItsNameAloneIsNot() {
        long plain = hash(VerbLevels.ROPE.replace("\"id\": \"line\", \"click\": \"cut\", ", ""));
        assertThat(hash(VerbLevels.ROPE.replace("\"click\": \"cut\", ", ""))).isEqualTo(plain);
        assertThat(hash(VerbLevels.ROPE)).isNotEqualTo(plain);
    }

    private static long hash(String text) {
        return LevelTexts.level(text).hash();
    }
}
