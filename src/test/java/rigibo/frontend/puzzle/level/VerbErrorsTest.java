package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.regex.Pattern;

/** Verbs of level files that are not possible. */
class VerbErrorsTest {

    private static void isTold(String level, String part, String replacement, String told) {
        String text =
                level.replaceFirst(
                        Pattern.quote(part.replace('\'', '"')),
                        replacement == null ? "" : replacement.replace('\'', '"'));
        assertThat(text).isNotEqualTo(level);
        assertThat(LevelTexts.problems(text))
                .anyMatch(line -> line.contains(told.replace('\'', '"')));
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
        isTold(VerbLevels.ROPE, part, replacement, told);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "'surfaceSpeed': -2, ; ; E124 a click switches a belt, a fan or a magnet only",
                "'click': 'freeze'; 'click': 'freeze', 'dynamic': false; E124 a click cannot"
                        + " freeze",
                "'click': 'freeze'; 'click': 'freeze', 'deletable': true; E124 is deletable and"
                        + " has",
                "'click': 'light',; ; E126 a 'blast' belongs to a body that a click lights",
                "'click': 'light',; 'click': 'light', 'on': true,; E126 'on' belongs to what",
                ", 'motor': {'speed': 4, 'most': 1000}; ; E124 a click cannot switch a joint",
            })
    void aMachineThatCannotWorkIsTold(String part, String replacement, String told) {
        isTold(VerbLevels.MACHINES, part, replacement, told);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "'dynamic': false, 'click': 'switch', 'on': false,; 'click': 'switch',; E127 a fan",
                "'fan', 'magnet']; 'magnet']; E140 the effect fan is not declared, but"
                        + " /bodies/1/fan",
                "'fan': {'width': 2, 'reach': 6, 'force': 2000};'drag': 0; E140 the effect fan is",
                "'reach': 8; 'reach': 0; must be 0.05 or more",
            })
    void aFanOrMagnetThatCannotBeIsTold(String part, String replacement, String told) {
        isTold(VerbLevels.SOURCES, part, replacement, told);
    }

    @Test
    void machinesNeedFormatTwo() {
        assertThat(
                        LevelTexts.problems(
                                VerbLevels.MACHINES.replace("\"format\": 2", "\"format\": 1")))
                .anyMatch(line -> line.contains("E103 \"click\" needs format 2"))
                .anyMatch(line -> line.contains("E103 \"blast\" needs format 2"));
    }

    /** The initial state of a switch decides how a level plays. */
    @Test
    void howASwitchBeginsIsPartOfTheHash() {
        long off = hash(VerbLevels.MACHINES);
        assertThat(hash(VerbLevels.MACHINES.replace("\"on\": false", "\"on\": true")))
                .isNotEqualTo(off);
        assertThat(hash(VerbLevels.MACHINES.replace("\"impulse\": 500", "\"impulse\": 501")))
                .isNotEqualTo(off);
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
        assertThat(LevelTexts.problems(solved("{\"t\": 1, \"joint\": \"line\"}"))).isEmpty();
        assertThat(LevelTexts.problems(solved("{\"t\": 1, \"joint\": \"hook\"}")))
                .anyMatch(line -> line.contains("E102 no joint has the id \"hook\""));
        assertThat(LevelTexts.problems(solved("{\"t\": 1, \"body\": \"line\"}")))
                .anyMatch(line -> line.contains("E102 no body has the id \"line\""));
        assertThat(LevelTexts.problems(solved("{\"t\": 1}")))
                .anyMatch(line -> line.contains("\"body\" is missing"));
        assertThat(
                        LevelTexts.problems(
                                solved("{\"t\": 1, \"body\": \"hook\", \"joint\": \"line\"}")))
                .isNotEmpty();
    }

    /** Levels without verbs keep their hash, so that their replays can still be played. */
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
