package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.util.List;

/** Features of format 2: capsules, round corners, compounds, driven platforms. */
class LevelFormatTwoTest {

    private static final String WALL =
            "{\"id\": \"wall\", \"shape\": {\"type\": \"box\", \"w\": 0.5, \"h\": 4}, \"x\": 8,"
                    + " \"y\": 2,\n     \"material\": \"stone\", \"dynamic\": false}";

    private static final String LIFT =
            "{\"id\": \"lift\", \"shape\": {\"type\": \"box\", \"w\": 1, \"h\": 0.2}, \"x\": 8,"
                    + " \"y\": 1, \"material\": \"iron\",\n"
                    + "     \"path\": {\"points\": [[8, 3], [7, 3]], \"speed\": 2, \"pause\": 1}}";

    /** The valid level of format 2 with another body in place of its wall. */
    private static String with(String body) {
        String sound = LevelTexts.with("\"format\": 1", "\"format\": 2");
        assertThat(sound).contains(WALL);
        return sound.replace(WALL, body);
    }

    private static String shaped(String shape) {
        return with(
                "{\"id\": \"thing\", \"shape\": "
                        + shape
                        + ",\n     \"x\": 7.5, \"y\": 5, \"angle\": 90, \"material\": \"stone\"}");
    }

    private static LevelBody thing(String text) {
        return LevelTexts.level(text).bodies().get(1);
    }

    @Test
    void aCapsuleIsStatedByTheWayBetweenItsEndsAndItsRadius() {
        LevelBody thing = thing(shaped("{\"type\": \"capsule\", \"length\": 1, \"r\": 0.2}"));
        assertThat(thing.shape()).isEqualTo(new Capsule(0.5, 0.2));
        assertThat(thing.definition().angle()).isEqualTo(Math.PI / 2);
    }

    @Test
    void aRoundBoxIsAsWideAndHighAsItSays() {
        LevelBody thing =
                thing(shaped("{\"type\": \"box\", \"w\": 1, \"h\": 0.5, \"round\": 0.1}"));
        assertThat(thing.shape()).isEqualTo(Polygon.box(0.8, 0.3).rounded(0.1));
        assertThat(thing.shape().smallestWidth()).isCloseTo(0.5, within(1e-12));
    }

    /**
     * Two boxes of 1 × 1 m side by side: the centre of mass is half way between, and above after
     * 90°.
     */
    @Test
    void aCompoundIsPlacedByThePointItsPartsAreStatedFrom() {
        String box = "{\"shape\": {\"type\": \"box\", \"w\": 1, \"h\": 1}";
        LevelBody thing =
                thing(
                        shaped(
                                "{\"type\": \"compound\", \"parts\": ["
                                        + box
                                        + "}, "
                                        + box
                                        + ", \"x\": 1}]}"));
        assertThat(((Compound) thing.shape()).parts()).isEqualTo(2);
        assertThat(thing.x()).isCloseTo(7.5, within(1e-12));
        assertThat(thing.y()).isCloseTo(5.5, within(1e-12));
    }

    /**
     * A triangle's centroid is a third of its height above its base; the part is turned by 180°.
     */
    @Test
    void aPolygonAmongThePartsIsPlacedByItsOwnPoint() {
        LevelBody thing =
                thing(
                        shaped(
                                "{\"type\": \"compound\", \"parts\": [{\"shape\": {\"type\":"
                                        + " \"polygon\", \"points\": [[0,0], [1,0], [0,3]]},"
                                        + " \"angle\": 180}]}"));
        Compound one = (Compound) thing.shape();
        assertThat(one.centroidX()).isCloseTo(-1.0 / 3, within(1e-12));
        assertThat(one.centroidY()).isCloseTo(-1, within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"type\": \"capsule\", \"length\": 1, \"r\": 0.2}",
                "{\"type\": \"capsule\", \"length\": 1, \"r\": 0.3}",
                "{\"type\": \"capsule\", \"length\": 1.2, \"r\": 0.2}",
                "{\"type\": \"box\", \"w\": 1, \"h\": 0.5, \"round\": 0.1}",
                "{\"type\": \"box\", \"w\": 1, \"h\": 0.5, \"round\": 0.2}",
                "{\"type\": \"compound\", \"parts\": [{\"shape\": {\"type\": \"circle\", \"r\":"
                        + " 0.4}}]}",
                "{\"type\": \"compound\", \"parts\": [{\"shape\": {\"type\": \"circle\", \"r\":"
                        + " 0.4}}, {\"shape\": {\"type\": \"circle\", \"r\": 0.4}, \"y\": 0.1}]}",
            })
    void theHashTellsOneShapeFromAllOthers(String shape) {
        long own = LevelTexts.level(shaped(shape)).hash();
        String plain = "{\"type\": \"box\", \"w\": 1, \"h\": 0.5}";
        assertThat(own).isNotEqualTo(LevelTexts.level(shaped(plain)).hash());
        assertThat(own).isEqualTo(LevelTexts.level(shaped(shape)).hash());
    }

    @Test
    void theHashSeesEveryNumberOfAPath() {
        long own = LevelTexts.level(with(LIFT)).hash();
        assertThat(
                        List.of(
                                LIFT.replace("\"speed\": 2", "\"speed\": 3"),
                                LIFT.replace("\"pause\": 1", "\"pause\": 2"),
                                LIFT.replace("[7, 3]", "[7, 4]"),
                                LIFT.replace("\"pause\": 1", "\"pause\": 1, \"end\": \"stay\"")))
                .allMatch(lift -> LevelTexts.level(with(lift)).hash() != own);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{'type': 'box', 'w': 1, 'h': 0.5, 'round': 0.3} | a.json:15:73:"
                        + " /bodies/1/shape/round: E112 corners too round: 0.300 m, at most 0.225"
                        + " of a box 0.500 m wide",
                "{'type': 'compound', 'parts': []} | a.json:15:60: /bodies/1/shape/parts: must have"
                        + " at least 1 items but found 0",
                "{'type': 'compound', 'parts': [{'shape': {'type': 'polygon', 'points':"
                        + " [[0,0],[1,0],[0.2,0.2],[0,1]]}}]} | a.json:15:114:"
                        + " /bodies/1/shape/parts/0/shape/points/2: E110 polygon not convex at the"
                        + " point (0.2, 0.2)",
                "{'type': 'compound', 'parts': [{'shape': {'type': 'compound', 'parts': []}}]} |"
                        + " a.json:15:80: /bodies/1/shape/parts/0/shape/type: \"compound\" is not"
                        + " one of box, circle, polygon, capsule",
                "{'type': 'capsule', 'r': 0.3} | a.json:15:30: /bodies/1/shape: \"length\" is"
                        + " missing",
            })
    void whatIsWrongWithAShapeIsToldWhereItStands(String shape, String expected) {
        assertThat(LevelTexts.problems(shaped(shape.replace('\'', '"')))).contains(expected);
    }

    @Test
    void aPathCannotMoveWhatForcesMoveNorLeadNowhere() {
        assertThat(
                        LevelTexts.problems(
                                with(LIFT.replace("\"path\"", "\"dynamic\": true, \"path\""))))
                .containsExactly(
                        "a.json:16:17: /bodies/1/dynamic: E116 a body with a path is driven and"
                                + " cannot be dynamic");
        assertThat(LevelTexts.problems(with(LIFT.replace("[7, 3]", "[8, 3]"))))
                .containsExactly(
                        "a.json:16:34: /bodies/1/path/points/1: E117 a way of 0.0000 m, at least"
                                + " 0.01: it is where the body comes from");
    }

    @Test
    void whatCameWithFormatTwoIsRefusedInAFileOfFormatOne() {
        String old = with(LIFT).replace("\"format\": 2", "\"format\": 1");
        assertThat(LevelTexts.problems(old))
                .containsExactly(
                        "a.json:16:14: /bodies/1/path: E103 \"path\" needs format 2, this file"
                                + " states 1");
        String round = "{\"type\": \"box\", \"w\": 1, \"h\": 1, \"round\": 0.1}";
        for (String shape : List.of("{\"type\": \"capsule\", \"length\": 1, \"r\": 0.2}", round)) {
            assertThat(LevelTexts.problems(shaped(shape).replace("\"format\": 2", "\"format\": 1")))
                    .singleElement()
                    .asString()
                    .contains("E103");
        }
    }

    private static final String FLOOR =
            "{\"id\": \"hill\", \"shape\": {\"type\": \"chain\", \"points\": [[3, 0], [1, 0.5],"
                    + " [0, 0]]},\n     \"x\": 6, \"y\": 5, \"material\": \"stone\","
                    + " \"dynamic\": false}";

    @Test
    void aChainIsALandscapeInTheFramesOfItsPoints() {
        LevelBody hill = thing(with(FLOOR));
        assertThat(hill.shape()).isEqualTo(Chain.open(3, 0, 1, 0.5, 0, 0));
        assertThat(hill.x()).isEqualTo(6);
        long own = LevelTexts.level(with(FLOOR)).hash();
        String loop = FLOOR.replace("[0, 0]]", "[0, 0]], \"loop\": true");
        assertThat(LevelTexts.level(with(loop)).hash()).isNotEqualTo(own);
        assertThat(LevelTexts.level(with(FLOOR.replace("0.5", "0.6"))).hash()).isNotEqualTo(own);
    }

    @Test
    void aChainThatCannotBeIsToldWithItsReason() {
        assertThat(LevelTexts.problems(with(FLOOR.replace("[0, 0]]", "[1, 0.5]]"))))
                .singleElement()
                .asString()
                .startsWith("a.json:15:57: /bodies/1/shape/points: E113 no landscape: ");
        assertThat(LevelTexts.problems(with(FLOOR.replace(", \"dynamic\": false", ""))))
                .containsExactly(
                        "a.json:15:5: /bodies/1: E115 a chain has no mass: state \"dynamic\":"
                                + " false, or a path");
    }

    /** Thrown up at 8 m/s from 1 m below, the ball passes the shelf; falling, it is held. */
    @Test
    void aShelfIsPassedFromBelowAndHoldsFromAbove() {
        String shelf = WALL.replace("\"dynamic\"", "\"oneWay\": 90, \"dynamic\"");
        String flat =
                shelf.replace("\"w\": 0.5, \"h\": 4", "\"w\": 2, \"h\": 0.2")
                        .replace("\"y\": 2", "\"y\": 4");
        Level level =
                LevelTexts.level(
                        with(flat)
                                .replace(
                                        "\"restitution\"]",
                                        "\"restitution\", \"continuous-impacts\"]")
                                .replace(
                                        "\"x\": 4.5, \"y\": 2.7", "\"x\": 8, \"y\": 3, \"vy\": 8"));
        assertThat(level.bodies().get(1).material().isOneWay()).isTrue();
        PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
        RigidBody ball = game.balls().get(0);
        double highest = 0;
        while (game.steps() < Steps.of(3)) {
            game.step();
            highest = Math.max(highest, ball.y());
        }
        // Undisturbed it rises by v²/2g; sampled at steps, by up to g·dt²/8 less.
        assertThat(highest).isCloseTo(3 + 64 / (2 * 9.81), within(0.001));
        assertThat(ball.y()).isCloseTo(4.1 + 0.35, within(0.001));
    }

    /**
     * At 2 m/s the lift leaves after a pause of one second and is 2 m higher one second later. It
     * waits, goes 1 m to the left in half a second, waits, and comes back the same way.
     */
    @Test
    void aLiftIsWhereItsPathSaysAtEachTimeAndComesBack() {
        PuzzleGame game = new PuzzleGame(LevelTexts.level(with(LIFT)), Accuracy.GAME);
        RigidBody lift = game.pieces().get(1).body();
        double[][] places = {
            {1, 8, 1}, {1.5, 8, 2}, {2, 8, 3}, {3, 8, 3}, {3.25, 7.5, 3}, {3.5, 7, 3},
            {4.5, 7, 3}, {5, 8, 3}, {6, 8, 3}, {7, 8, 1}, {8, 8, 1}, {9, 8, 3}
        };
        for (double[] place : places) {
            while (game.steps() < Steps.of(place[0])) {
                game.step();
            }
            assertThat(lift.x()).as("x after %s s", place[0]).isCloseTo(place[1], within(1e-9));
            assertThat(lift.y()).as("y after %s s", place[0]).isCloseTo(place[2], within(1e-9));
        }
    }

    @Test
    void aRoundPathGoesStraightToItsStartAndOneThatStaysStays() {
        String round = LIFT.replace("\"pause\": 1", "\"end\": \"round\"");
        assertThat(after(round, 1 + 0.5)[0]).isCloseTo(7, within(1e-9));
        // √(1² + 2²) m back at 2 m/s, in whole steps.
        int home = Steps.of(Math.sqrt(5) / 2);
        double[] back = after(round, 1.5 + Steps.seconds(home));
        assertThat(back).containsExactly(new double[] {8, 1}, within(1e-9));
        String stays = LIFT.replace("\"pause\": 1", "\"end\": \"stay\"");
        assertThat(after(stays, 10)).containsExactly(new double[] {7, 3}, within(1e-9));
    }

    private static double[] after(String lift, double seconds) {
        PuzzleGame game = new PuzzleGame(LevelTexts.level(with(lift)), Accuracy.GAME);
        while (game.steps() < Steps.of(seconds)) {
            game.step();
        }
        RigidBody body = game.pieces().get(1).body();
        return new double[] {body.x(), body.y()};
    }

    /** The editor moves and turns bodies that it cannot edit, and loses none of their members. */
    @Test
    void theEditorKeepsWhatItCannotEdit() {
        String part = "{\"shape\": {\"type\": \"capsule\", \"length\": 1, \"r\": 0.2}, \"y\": 0.3}";
        String shape = "{\"type\": \"compound\", \"parts\": [" + part + "]}";
        Draft draft = draft(shaped(shape).replace("\"angle\": 90", "\"angle\": 0"));
        Item thing = draft.item("/bodies/1").orElseThrow();
        assertThat(thing.contains(new Point(7.5, 5.3))).isTrue();
        assertThat(thing.contains(new Point(7.5, 5.05))).isFalse();
        assertThat(thing.corners()).hasSizeGreaterThan(20);
        Draft moved = draft.with(thing.at(new Point(2, 3)).turnedTo(30));
        String text = moved.toString();
        assertThat(text).contains("\"parts\": [" + part + "]").contains("\"x\": 2");
        Draft lifted = draft(with(LIFT));
        Item lift = lifted.item("/bodies/1").orElseThrow();
        assertThat(lift.isFixed()).isTrue();
        assertThat(lifted.with(lift.at(new Point(6, 1))).toString())
                .contains("\"path\": {\"points\": [[8, 3], [7, 3]], \"speed\": 2, \"pause\": 1}");
    }

    private static Draft draft(String text) {
        return Draft.of(new LevelLoader().parse("a.json", text).document().orElseThrow());
    }
}
