package rigibo.frontend.puzzle.check;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.level.StarLevels;
import rigibo.frontend.scene.accuracy.Preset;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;

/** Problems that only play shows, each with its own message. */
class LevelCheckTest {

    /** The box lies on a beam between two posts; deleting one of them does not release the ball. */
    private static final String TWO_FLOORS =
            LevelTexts.with("\"par\": 1", "\"par\": 2")
                    .replace("\"y\": 2.7", "\"y\": 3.7")
                    .replace("\"bodies\": [", "\"bodies\": [" + box("roof", 2.85))
                    .replace(
                            "{\"t\": 1.0, \"body\": \"box\"}",
                            "{\"t\": 1.0, \"body\": \"box\"}, {\"t\": 2.0, \"body\": \"roof\"}");

    private static final Predicate<String> OUT_OF_BOUNDS =
            line -> line.startsWith("  out of bounds: ");

    @TempDir private Path folder;

    private static String box(String id, double y) {
        return "{\"id\": \""
                + id
                + "\", \"shape\": {\"type\": \"box\", \"w\": 2, \"h\": 1}, \"x\": 4.5, \"y\": "
                + y
                + ", \"material\": \"rigibo\", \"deletable\": true},";
    }

    private List<String> check(String text) {
        return check(text, "a.json");
    }

    private List<String> check(String text, String name) {
        StringWriter out = new StringWriter();
        try {
            Path file = Files.writeString(folder.resolve(name), text);
            new LevelsCheck(List.of(Preset.GAME), new PrintWriter(out)).run(List.of(file));
        } catch (IOException broken) {
            throw new java.io.UncheckedIOException(broken);
        }
        return out.toString().replace(folder + "/", "").lines().toList();
    }

    @Test
    void aSoundLevelIsToldWhatWasProved() {
        assertThat(check(LevelTexts.SOUND))
                .containsExactly(
                        "a.json: ok",
                        "  box at 1.0 s: wins 41 of 41 games",
                        "  none of all 0 games of fewer clicks wins",
                        "  1 of all 1 orders and times of 1 clicks win (100 %)",
                        "  first clicks that mislead: 0",
                        "  the rest misleads without: 0",
                        "1 levels, 0 with errors");
    }

    @Test
    void twoFloorsNeedTwoClicksAndTheOrderDoesNotMatter() {
        assertThat(check(TWO_FLOORS))
                .startsWith(
                        "a.json: ok",
                        "  box at 1.0 s, roof at 2.0 s: wins 41 of 41 games",
                        "  no single click wins")
                .element(4)
                .asString()
                .contains("of all", "(100 %)");
    }

    /** At the end of its world, luck should not win it. */
    @Test
    void aLevelOfTheGameIsHeldToTheBoundsOfItsPlace() {
        assertThat(check(LevelTexts.SOUND, "1-03-a.json")).noneMatch(OUT_OF_BOUNDS);
        assertThat(check(LevelTexts.SOUND, "1-09-a.json"))
                .startsWith("1-09-a.json: ok")
                .filteredOn(OUT_OF_BOUNDS)
                .containsExactly(
                        "  out of bounds: par is less than 2",
                        "  out of bounds: more than 5 % of orders and times win",
                        "  out of bounds: nothing misleads");
    }

    @Test
    void aSolutionThatDoesNotWinIsToldWithTheReason() {
        String elsewhere =
                LevelTexts.with("\"x\": 4.5, \"y\": 2.7", "\"x\": 8, \"y\": 4.35")
                        .replace("\"w\": 0.5, \"h\": 4", "\"w\": 1.8, \"h\": 4");
        assertThat(check(elsewhere))
                .contains(
                        "a.json:19:5: /solutions/0: E151 wins only 0 of 41 games with everything up"
                                + " to 10 mm aside and clicks up to 0.25 s late; lost at GAME: the"
                                + " ball is lost: nothing left to delete at 2.00 s");
    }

    @Test
    void aStarIsProvedByItsOwnClicks() {
        String clicks = "{\"t\": 1, \"body\": \"box\"}, {\"t\": 2, \"body\": \"wall\"}";
        assertThat(check(StarLevels.text("'type': 'clear'", clicks)))
                .startsWith(
                        "a.json: ok",
                        "  box at 1.0 s: wins 41 of 41 games",
                        "  secret star: earned in 41 of 41 games");
        assertThat(check(StarLevels.text("'type': 'clear'")))
                .anyMatch(
                        line ->
                                line.contains(
                                        "/star: E154 its solution does not earn it at GAME: won"));
    }

    /** The solution shown to players must not earn the star. */
    @Test
    void aStarThatIsShownIsNoSecret() {
        assertThat(check(StarLevels.text("'type': 'keep', 'body': 'wall'")))
                .anyMatch(line -> line.contains("/star: E154 is no secret"));
    }

    /** With clicks up to 0.1 s late, most games miss the time. */
    @Test
    void aStarThatTakesLuckIsTold() {
        String soon = "{\"t\": 0, \"body\": \"box\"}";
        assertThat(check(StarLevels.text("'type': 'quick', 'seconds': 3.5", soon)))
                .anyMatch(line -> line.contains("/star: E154 needs luck: earned in "));
    }

    @Test
    void aParThatOneClickBeatsIsToldWithTheClick() {
        String second =
                LevelTexts.with("\"par\": 1", "\"par\": 2")
                        .replace(
                                "\"bodies\": [",
                                "\"bodies\": [" + box("other", 5).replace("4.5", "1.5"))
                        .replace("\"x\": 4.5, \"y\": 5.0", "\"x\": 1.5, \"y\": 5.0")
                        .replace(
                                "{\"t\": 1.0, \"body\": \"box\"}",
                                "{\"t\": 1.0, \"body\": \"box\"}, {\"t\": 2.0, \"body\":"
                                        + " \"other\"}");
        assertThat(check(second))
                .contains(
                        "a.json:9:50: /rules/par: E152 par is 2, but one click on \"box\" wins at"
                                + " GAME",
                        "a.json:19:5: /solutions/0: E152 has a click too many: at GAME \"box\" is"
                                + " enough");
    }

    @Test
    void aLevelThatMovesByItselfIsToldWhatMovesAndHowFar() {
        String falling =
                LevelTexts.with("\"y\": 1.85", "\"y\": 1.95").replace("\"y\": 2.7", "\"y\": 2.8");
        assertThat(check(falling))
                .contains(
                        "a.json:10:11: /ball: E160 not at rest before the first click: the ball"
                                + " moves by 100 mm in 3 s",
                        "a.json:13:5: /bodies/0: E160 not at rest before the first click: \"box\""
                                + " moves by 100 mm in 3 s");
    }
}
