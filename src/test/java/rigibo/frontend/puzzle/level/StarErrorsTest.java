package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.document.Problem;

import java.util.List;

/** Stars of level files that are not possible. */
class StarErrorsTest {

    /** The errors; a wall that can be deleted is only a warning. */
    private static List<String> errors(String text) {
        return new LevelLoader()
                .parse("a.json", text).problems().stream()
                        .filter(Problem::isError)
                        .map(Problem::toString)
                        .toList();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "'type': 'clicks', 'count': 2",
                "'type': 'quick', 'seconds': 4",
                "'type': 'avoid', 'body': 'wall'",
                "'type': 'avoid', 'material': 'stone'",
                "'type': 'touch', 'body': 'box'",
                "'type': 'keep', 'body': 'wall'",
                "'type': 'clear'",
                "'type': 'inside'",
                "'type': 'first', 'body': 'wall'",
            })
    void everyTypeIsRead(String feat) {
        assertThat(errors(StarLevels.text(feat))).isEmpty();
        assertThat(StarLevels.level(feat).star().orElseThrow().solution().clicks()).hasSize(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "'type': 'clicks', 'count': 51; /star/count: must be 50 or less",
                "'type': 'quick', 'seconds': 3; /star: E153 the hold alone takes 3.0 s",
                "'type': 'avoid', 'material': 'ice'; /star: E153 nothing is of ice",
                "'type': 'avoid', 'body': 'bx'; /star/body: E102 no body has the id 'bx', did you",
                "'type': 'keep', 'body': 'platform'; /star/body: E102 no body has the id",
                "'type': 'first', 'joint': 'box'; /star/joint: E102 no joint has the id 'box'",
                "'type': 'avoid'; /star: 'body' is missing",
                "'type': 'touch', 'material': 'ice'; /star/material: 'material' is not known here",
                "'type': 'luck'; /star/type: 'luck' is not one of clicks, quick, avoid",
            })
    void aStarThatCannotBeIsTold(String feat, String told) {
        assertThat(errors(StarLevels.text(feat)))
                .anyMatch(line -> line.contains(told.replace('\'', '"')));
    }

    /** In the valid level the wall is fixed, and only the box can be clicked. */
    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "'type': 'keep', 'body': 'wall'; E153 'wall' stays in the world in any game",
                "'type': 'first', 'body': 'wall'; E153 a click does nothing to 'wall'",
                "'type': 'first', 'body': 'box'; E153 every game begins with 'box'",
                "'type': 'clicks', 'count': 3; E153 3 clicks are more than the rules allow",
                "'type': 'clicks', 'count': 2; E153 only 1 can be clicked",
            })
    void aStarThatNoGameOrEveryGameEarnsIsTold(String feat, String told) {
        String text =
                StarLevels.text(feat)
                        .replace(", \"deletable\": true}\n  ],", "}\n  ],")
                        .replace("\"par\": 1", "\"par\": 1, \"maxClicks\": 2");
        assertThat(errors(text)).singleElement().asString().contains(told.replace('\'', '"'));
    }

    @Test
    void clicksOfAStarKeepTheRules() {
        String soon = "{\"t\": 1, \"body\": \"box\"}, {\"t\": 1.5, \"body\": \"wall\"}";
        assertThat(errors(StarLevels.text("'type': 'clear'", soon)))
                .singleElement()
                .asString()
                .contains("/star/solution/clicks/1/t: E150");
    }

    @Test
    void aStarNeedsFormatTwoAndChangesNoHash() {
        String text = StarLevels.text("'type': 'inside'");
        assertThat(errors(text.replace("\"format\": 2", "\"format\": 1")))
                .singleElement()
                .asString()
                .contains("/star: E103 \"star\" needs format 2");
        assertThat(StarLevels.level("'type': 'inside'").hash())
                .isEqualTo(StarLevels.level("'type': 'clear'").hash());
    }
}
