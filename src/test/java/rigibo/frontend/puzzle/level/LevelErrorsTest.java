package rigibo.frontend.puzzle.level;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.document.Problem;

import java.util.List;
import java.util.stream.Stream;

class LevelErrorsTest {

    private final LevelLoader loader = new LevelLoader();

    private List<String> problems(String text) {
        return loader.parse("a.json", text).problems().stream().map(Problem::toString).toList();
    }

    @Test
    void aSoundLevelHasNoProblem() {
        assertThat(problems(LevelTexts.SOUND)).isEmpty();
    }

    static Stream<Arguments> broken() {
        return Stream.of(
                Arguments.of(
                        "\"id\": \"wall\"",
                        "\"id\": \"box\"",
                        "a.json:15:12: /bodies/1/id: E101 body id \"box\" is used twice (first at"
                                + " 13:12)"),
                Arguments.of(
                        "\"body\": \"box\"",
                        "\"body\": \"bx\"",
                        "a.json:19:36: /solutions/0/clicks/0/body: E102 no body has the id \"bx\","
                                + " did you mean \"box\"?"),
                Arguments.of(
                        "{\"type\": \"box\", \"w\": 0.5, \"h\": 4}",
                        "{\"type\": \"polygon\", \"points\": [[0,0], [1,0], [0.2,0.2], [0,1]]}",
                        "a.json:15:74: /bodies/1/shape/points/2: E110 polygon not convex at the"
                                + " point (0.2, 0.2)"),
                Arguments.of(
                        "{\"type\": \"box\", \"w\": 0.5, \"h\": 4}",
                        "{\"type\": \"polygon\", \"points\": [[0,0], [0.05,0], [0,0.05]]}",
                        "a.json:15:59: /bodies/1/shape/points: E111 area too small: 0.0013 m², at"
                                + " least 0.0025"),
                Arguments.of(
                        "\"y\": 1.85",
                        "\"y\": 1.8",
                        "a.json:13:5: /bodies/0: E120 overlaps the platform at the start by 50.0"
                                + " mm"),
                Arguments.of(
                        "\"ball\": {\"x\": 4.5",
                        "\"ball\": {\"x\": 9.5",
                        "a.json:10:11: /ball: E121 the ball starts outside the world: at (9.5, 2.7)"
                                + " with radius 0.35 in 9.0 × 10.0 m"),
                Arguments.of(
                        "\"deletable\": true",
                        "\"deletable\": false",
                        "a.json:12:13: /bodies: E130 nothing can be clicked"),
                Arguments.of(
                        "\"dynamic\": false",
                        "\"dynamic\": false, \"deletable\": true",
                        "a.json:15:5: /bodies/1: warning: E131 body \"wall\" never moves but can be"
                                + " deleted"),
                Arguments.of(
                        "\"restitution\"]",
                        "\"restitution\", \"thrust\"]",
                        "a.json:7:16: /world/effects: warning: E140 the effect thrust is declared,"
                                + " but nothing uses it"),
                Arguments.of(
                        "\"material\": \"stone\"",
                        "\"material\": \"stone\", \"rollingResistance\": 0.1",
                        "a.json:7:16: /world/effects: warning: E140 the effect rolling-resistance"
                                + " is not declared, but /bodies/1/rollingResistance is not zero"),
                Arguments.of(
                        "\"material\": \"stone\"",
                        "\"material\": \"stone\", \"surfaceSpeed\": -2",
                        "a.json:7:16: /world/effects: warning: E140 the effect surface-speed"
                                + " is not declared, but /bodies/1/surfaceSpeed is not zero"),
                Arguments.of(
                        "\"restitution\"]",
                        "\"restitution\", \"buoyancy\"]",
                        "a.json:7:16: /world/effects: warning: E140 the effect buoyancy is"
                                + " declared, but nothing uses it"),
                Arguments.of(
                        "\"height\": 10,",
                        "\"height\": 10, \"water\": {\"level\": 1},",
                        "a.json:7:16: /world/effects: warning: E140 the effect buoyancy is not"
                                + " declared, but /world/water is there"),
                Arguments.of(
                        "\"platform\"",
                        "\"moreBalls\": [{\"x\": 4.6, \"y\": 3.3, \"radius\": 0.3}], \"platform\"",
                        "a.json:11:17: /moreBalls/0: E120 overlaps the ball at the start by 41.7"
                                + " mm"),
                Arguments.of(
                        "\"platform\"",
                        "\"moreBalls\": [{\"x\": 0, \"y\": 3, \"radius\": 0.3}], \"platform\"",
                        "a.json:11:17: /moreBalls/0: E121 ball 2 starts outside the world: at (0.0,"
                                + " 3.0) with radius 0.3 in 9.0 × 10.0 m"),
                Arguments.of(
                        "{\"t\": 1.0, \"body\": \"box\"}",
                        "{\"t\": 1.0, \"body\": \"box\"}, {\"t\": 1.98, \"body\": \"box\"}",
                        "a.json:19:50: /solutions/0/clicks/1/t: E150 clicks at 1.98 s, during the"
                                + " cooldown that lasts until 2.0 s"),
                Arguments.of(
                        "\"par\": 1",
                        "\"par\": 2",
                        "a.json:9:50: /rules/par: E152 par is 2, but /solutions/0 needs only 1"));
    }

    @ParameterizedTest
    @MethodSource("broken")
    void eachRuleTellsItsOwnErrorAtItsPlaceAndNoOther(
            String sound, String broken, String expected) {
        assertThat(problems(LevelTexts.with(sound, broken))).containsExactly(expected);
    }

    static Stream<Arguments> againstTheSchema() {
        return Stream.of(
                Arguments.of(
                        "\"radius\"",
                        "\"raduis\"",
                        List.of(
                                "a.json:10:11: /ball: \"radius\" is missing",
                                "a.json:10:42: /ball/raduis: \"raduis\" is not known here, did you"
                                        + " mean \"radius\"?")),
                Arguments.of(
                        "\"material\": \"stone\"",
                        "\"material\": \"stoen\"",
                        List.of(
                                "a.json:16:18: /bodies/1/material: \"stoen\" is not one of rigibo,"
                                    + " stone, plank, ice, rubber, iron, ball, ember, did you mean"
                                    + " \"stone\"?")),
                Arguments.of(
                        "\"cooldown\": 1.0",
                        "\"cooldown\": \"fast\"",
                        List.of("a.json:9:25: /rules/cooldown: must be a number, was \"fast\"")),
                Arguments.of(
                        "\"w\": 0.5, \"h\": 4",
                        "\"w\": 0.01, \"h\": 4",
                        List.of("a.json:15:50: /bodies/1/shape/w: must be 0.05 or more, was 0.01")),
                Arguments.of(
                        "\"type\": \"box\", \"w\": 0.5, \"h\": 4",
                        "\"type\": \"box\", \"w\": 0.5",
                        List.of("a.json:15:29: /bodies/1/shape: \"h\" is missing")),
                Arguments.of(
                        "\"format\": 1",
                        "\"format\": 0",
                        List.of("a.json:2:13: /format: must be 1 or more, was 0")));
    }

    @ParameterizedTest
    @MethodSource("againstTheSchema")
    void whatTheSchemaForbidsIsToldInPlainWords(
            String sound, String broken, List<String> expected) {
        assertThat(problems(LevelTexts.with(sound, broken))).containsExactlyElementsOf(expected);
    }

    @Test
    void anEffectWithoutItsCompanionNamesBoth() {
        assertThat(problems(LevelTexts.with("\"contacts\", ", "")))
                .containsExactly(
                        "a.json:7:16: /world/effects: Friction needs Contacts, which is not"
                                + " declared");
    }

    @Test
    void errorsOfAllKindsAreToldAtOnceInTheOrderOfTheFile() {
        String text =
                LevelTexts.with("\"hold\": 3.0", "\"hold\": -1")
                        .replace("\"y\": 2.7", "\"y\": 20")
                        .replace("\"id\": \"wall\"", "\"id\": \"box\"")
                        .replace("\"body\": \"box\"", "\"body\": \"boxx\"");
        assertThat(problems(text))
                .containsExactly(
                        "a.json:9:38: /rules/hold: must be 0.1 or more, was -1",
                        "a.json:10:11: /ball: E121 the ball starts outside the world: at (4.5,"
                                + " 20.0) with radius 0.35 in 9.0 × 10.0 m",
                        "a.json:15:12: /bodies/1/id: E101 body id \"box\" is used twice (first at"
                                + " 13:12)",
                        "a.json:19:36: /solutions/0/clicks/0/body: E102 no body has the id"
                                + " \"boxx\", did you mean \"box\"?");
    }

    @Test
    void aClickExactlyAtTheCooldownsEndIsAllowed() {
        String text =
                LevelTexts.with(
                        "{\"t\": 1.0, \"body\": \"box\"}",
                        "{\"t\": 1.0, \"body\": \"box\"}, {\"t\": 2.0, \"body\": \"box\"}");
        assertThat(problems(text)).isEmpty();
    }

    @Test
    void aNewerFormatIsTheOnlyMessage() {
        String text = LevelTexts.with("\"format\": 1", "\"format\": 3").replace("ball", "orb");
        assertThat(problems(text))
                .containsExactly(
                        "a.json:2:13: /format: made for a newer RigiBo (format 3); this version"
                                + " reads 2");
    }
}
