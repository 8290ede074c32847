package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Joint;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.JointKind;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.puzzle.rules.ClickResult;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.util.List;

/** Joints in levels: reading, errors, and play. */
class LevelJointsTest {

    private static final String ROPE =
            "{\"type\": \"rope\", \"a\": \"hook\", \"b\": \"ball\", \"from\": [2, 8], \"to\": [2,"
                    + " 5], \"length\": 3}";

    /** A ball on a hook that a click deletes; the platform lies below. */
    private static String hanging(String joints) {
        return """
        {
          "format": 2,
          "id": "hang",
          "title": {"en": "Hang"},
          "world": {
            "width": 9, "height": 10, "gravity": [0, -9.81],
            "effects": ["gravity", "contacts", "rotation", "friction", "joints"]
          },
          "rules": {"cooldown": 1.0, "hold": 3.0, "par": 1},
          "ball": {"x": 2, "y": 5, "radius": 0.35},
          "platform": {"x": 2, "y": 1.2, "w": 3},
          "bodies": [
            {"id": "hook", "shape": {"type": "box", "w": 0.6, "h": 0.6}, "x": 2, "y": 8.3,
             "material": "rigibo", "dynamic": false, "deletable": true},
            {"id": "bar", "shape": {"type": "box", "w": 2, "h": 0.2}, "x": 6, "y": 5,
             "material": "plank"},
            {"id": "post", "shape": {"type": "box", "w": 0.3, "h": 5}, "x": 6, "y": 2.5,
             "material": "stone", "dynamic": false}
          ],
          "joints": [
            JOINTS
          ]
        }
        """
                .replace("JOINTS", joints);
    }

    private static final String HINGE =
            "{\"type\": \"hinge\", \"a\": \"post\", \"b\": \"bar\", \"at\": [6, 5]}";

    private static LevelJoint joint(String text) {
        Level level = LevelTexts.level(hanging(text + ",\n" + ROPE));
        return level.joints().get(0);
    }

    @Test
    void aHingeIsReadWithItsLimitsAndItsMotor() {
        LevelJoint hinge =
                joint(
                        "{\"type\": \"hinge\", \"a\": \"post\", \"b\": \"bar\", \"at\": [6, 5],"
                                + " \"limits\": [-90, 45], \"motor\": {\"speed\": 2, \"most\": 30},"
                                + " \"breakForce\": 500}");
        assertThat(hinge.type()).isEqualTo(LevelJoint.Type.HINGE);
        assertThat(hinge.settings().limits().lower()).isCloseTo(-Math.PI / 2, within(1e-15));
        assertThat(hinge.settings().limits().upper()).isCloseTo(Math.PI / 4, within(1e-15));
        assertThat(hinge.settings().motor().speed()).isEqualTo(2);
        assertThat(hinge.settings().motor().most()).isEqualTo(30);
        assertThat(hinge.settings().breakForce()).isEqualTo(500);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "{'type': 'weld', 'a': 'post', 'b': 'bar', 'at': [6, 5]}; WELD",
                "{'type': 'wheel', 'a': 'post', 'b': 'bar', 'at': [6, 5]}; WHEEL",
                "{'type': 'slide', 'a': 'post', 'b': 'bar', 'at': [6, 5]}; PRISMATIC",
                "{'type': 'rod', 'a': 'post', 'b': 'bar', 'from': [6, 5], 'to': [5, 5]}; DISTANCE",
                "{'type': 'spring', 'a': 'post', 'b': 'bar', 'from': [6, 4], 'to': [5, 5],"
                        + " 'spring': {'hertz': 2}}; DISTANCE"
            })
    void eachTypeIsAJointOfThePool(String text, JointKind kind) {
        String json = text.replace('\'', '"') + ",\n" + ROPE;
        PuzzleGame game = new PuzzleGame(LevelTexts.level(hanging(json)), Accuracy.GAME);
        assertThat(game.pool().joints()).extracting(Joint::kind).contains(kind);
    }

    /** The rope holds the ball in place; without the hook it falls on the platform. */
    @Test
    void aRopeCarriesTheBallUntilItsHookIsDeleted() {
        PuzzleGame game =
                new PuzzleGame(LevelTexts.level(hanging(HINGE + ",\n" + ROPE)), Accuracy.GAME);
        RigidBody ball = game.balls().get(0);
        for (int i = 0; i < 120; i++) {
            game.step();
        }
        assertThat(ball.y()).isCloseTo(5, within(1e-4));
        assertThat(game.act("hook")).isEqualTo(ClickResult.DONE);
        assertThat(game.pool().joints()).hasSize(1);
        for (int i = 0; i < 120; i++) {
            game.step();
        }
        assertThat(game.pool().touching(ball, game.platform())).isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "{'type': 'hinge', 'a': 'posst', 'b': 'bar', 'at': [6, 5]};"
                        + " /joints/0/a; E102 nothing is called \"posst\", did you mean \"post\"?",
                "{'type': 'hinge', 'a': 'bar', 'b': 'bar', 'at': [6, 5]};"
                        + " /joints/0; E118 joins \"bar\" with itself",
                "{'type': 'weld', 'a': 'post', 'b': 'platform', 'at': [6, 5]};"
                        + " /joints/0; E118 joins two bodies that forces do not move",
                "{'type': 'rope', 'a': 'hook', 'b': 'ball', 'from': [2, 8], 'to': [2, 5],"
                        + " 'length': 2.5}; /joints/0/length;"
                        + " E122 a rope of 2.500 m between ends that are 3.000 m apart",
                "{'type': 'hinge', 'a': 'post', 'b': 'bar', 'at': [6, 5], 'limits': [10, 20]};"
                        + " /joints/0/limits; E123 begins at 0.0, outside of its limits 10.0 to"
                        + " 20.0",
                "{'type': 'hinge', 'a': 'post', 'b': 'bar', 'at': [6, 5], 'limits': [20, 10]};"
                        + " /joints/0/limits; E123 begins at 0.0, outside of its limits 20.0 to"
                        + " 10.0"
            })
    void whatCannotBeIsToldWhereItStands(String text, String pointer, String words) {
        // The bar overlaps its post, which only joined bodies may.
        List<String> problems = LevelTexts.problems(hanging(text.replace('\'', '"')));
        assertThat(problems)
                .anyMatch(told -> told.contains(pointer + ": ") && told.contains(words));
    }

    @Test
    void whoAreJoinedMayOverlapAtTheStart() {
        assertThat(LevelTexts.problems(hanging(HINGE + ",\n" + ROPE))).isEmpty();
        assertThat(LevelTexts.problems(hanging(ROPE)))
                .hasSize(1)
                .allMatch(told -> told.contains("E120"));
    }

    @Test
    void jointsNeedTheirEffectAndFormatTwo() {
        assertThat(LevelTexts.problems(hanging(HINGE).replace(", \"joints\"]", "]")))
                .anyMatch(told -> told.contains("E119"));
        assertThat(LevelTexts.problems(hanging(HINGE).replace("\"format\": 2", "\"format\": 1")))
                .filteredOn(told -> told.contains("E103"))
                .hasSize(2);
        assertThat(LevelTexts.problems(hanging("")))
                .anyMatch(told -> told.contains("E140") && told.contains("joints"));
    }

    /** A replay of the level with another rope must be refused. */
    @Test
    void theHashTellsOneJointFromAnother() {
        long plain = LevelTexts.level(hanging(HINGE)).hash();
        String longer = ROPE.replace("\"length\": 3", "\"length\": 3.5");
        long one = LevelTexts.level(hanging(HINGE + ",\n" + ROPE)).hash();
        long other = LevelTexts.level(hanging(HINGE + ",\n" + longer)).hash();
        assertThat(List.of(plain, one, other)).doesNotHaveDuplicates();
    }

    /** The editor has no tools for joints, and loses none of them. */
    @Test
    void theEditorKeepsJoints() {
        Level level = LevelTexts.level(hanging(HINGE + ",\n" + ROPE));
        LoadedLevel loaded = new LevelLoader().parse("a.json", hanging(HINGE + ",\n" + ROPE));
        String kept = Draft.of(loaded.document().orElseThrow()).toString();
        assertThat(LevelTexts.level(kept).joints()).isEqualTo(level.joints()).hasSize(2);
    }
}
