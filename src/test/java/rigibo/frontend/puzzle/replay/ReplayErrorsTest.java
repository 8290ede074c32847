package rigibo.frontend.puzzle.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.Correction;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.ImpactSearch;
import rigibo.backend.setup.Integrator;
import rigibo.frontend.document.Mutations;
import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.LevelTexts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

class ReplayErrorsTest {

    private static final String HASH = Hex.of(LevelTexts.sound().hash());

    private static final String OTHER_REVISION =
            "was played in revision 99 of the simulation, by RigiBo 0.0.9; this is revision "
                    + Pool.REVISION
                    + ", in which bodies move otherwise: it is kept, and not played";

    /** The text to which line numbers in the tests refer. */
    private static final String SOUND =
            """
            {
              "format": 2,
              "game": "0.0.9",
              "revision": REVISION,
              "level": {"id": "drop", "title": "Drop", "hash": "HASH"},
              "accuracy": {
                "substeps": 4, "velocityIterations": 1, "impacts": "EVENTS",
                "impactTolerance": 1e-4, "search": "ITP", "maxImpactsPerPair": 16,
                "integrator": "BALLISTIC", "contactSolver": "DIRECT", "correction": "SOFT"
              },
              "clicks": [
                {"step": 60, "body": "box"},
                {"step": 130, "body": "wall"}
              ],
              "hashes": {
                "0": "995bca2a5ba82fbb",
                "269": "cb4ef448aff17123"
              }
            }
            """
                    .replace("REVISION", "" + Pool.REVISION)
                    .replace("HASH", HASH);

    @TempDir Path folder;

    private final ReplayLoader loader = new ReplayLoader(List.of(LevelTexts.sound()));

    private List<String> problems(String text) {
        return words(loader.parse("a.replay.json", text));
    }

    private static List<String> words(LoadedReplay loaded) {
        assertThat(loaded.recording().isPresent()).isEqualTo(loaded.problems().isEmpty());
        return loaded.problems().stream().map(Problem::toString).toList();
    }

    @Test
    void onlyAReplayOfAnotherRevisionIsSaidToBeOne() {
        assertThat(loader.parse("a", SOUND).otherRevision()).isEmpty();
        assertThat(loader.parse("a", "{").otherRevision()).isEmpty();
        String other = with("\"revision\": " + Pool.REVISION, "\"revision\": 99");
        assertThat(loader.parse("a", other).otherRevision()).hasValue(99);
        String first = with("\"format\": 2", "\"format\": 1");
        assertThat(loader.parse("a", first).otherRevision()).hasValue(0);
    }

    private static String with(String part, String replacement) {
        assertThat(SOUND).contains(part);
        return SOUND.replace(part, replacement);
    }

    @Test
    void noValueOfAnyPartIsWorseThanAProblem() {
        Mutations.of(SOUND)
                .forEach(
                        mutated ->
                                assertThat(problems(mutated))
                                        .allSatisfy(line -> assertThat(line).doesNotContain("\n")));
    }

    @Test
    void aSoundReplayHasNoProblem() {
        assertThat(problems(SOUND)).isEmpty();
    }

    static Stream<Arguments> broken() {
        return Stream.of(
                Arguments.of(
                        "\"revision\": " + Pool.REVISION,
                        "\"revision\": 99",
                        "4:15: /revision: " + OTHER_REVISION),
                Arguments.of(
                        "\"format\": 2",
                        "\"format\": 1",
                        "2:13: /format: " + OTHER_REVISION.replace("revision 99", "revision 0")),
                Arguments.of(
                        "\"id\": \"drop\"",
                        "\"id\": \"drip\"",
                        "5:19: /level/id: belongs to the level \"drip\", which is not here, did you"
                                + " mean \"drop\"?"),
                Arguments.of(
                        "\"hash\": \"" + HASH,
                        "\"hash\": \"0123456789abcdef",
                        "5:52: /level/hash: the level \"drop\" was altered since this was played:"
                                + " its hash is "
                                + HASH
                                + " now, and was 0123456789abcdef"),
                Arguments.of(
                        "\"hash\": \"" + HASH,
                        "\"hash\": \"12",
                        "5:52: /level/hash: must be 16 hexadecimal digits, was \"12\""),
                Arguments.of(
                        "\"format\": 2",
                        "\"format\": 3",
                        "2:13: /format: made for a newer RigiBo (format 3); this version reads 2"),
                Arguments.of("\"search\": \"ITP\", ", "", "6:15: /accuracy: \"search\" is missing"),
                Arguments.of(
                        "\"substeps\": 4",
                        "\"substeps\": 65",
                        "7:17: /accuracy/substeps: must be 64 or less, was 65"),
                Arguments.of(
                        "\"EVENTS\"",
                        "\"EVENT\"",
                        "7:56: /accuracy/impacts: \"EVENT\" is not one of DISCRETE, SPLIT, EVENTS,"
                                + " did you mean \"EVENTS\"?"),
                Arguments.of(
                        "\"step\": 130",
                        "\"step\": 30",
                        "13:14: /clicks/1/step: is before the click at step 60"),
                Arguments.of(
                        "\"step\": 130",
                        "\"step\": 269",
                        "13:14: /clicks/1/step: is not before the end, which is at step 269"),
                Arguments.of(
                        "\"step\": 130",
                        "\"step\": 1.5",
                        "13:14: /clicks/1/step: must be an integer, was 1.5"),
                Arguments.of(
                        "\"995bca2a5ba82fbb\"",
                        "\"995bca2a5ba82fbX\"",
                        "16:10: /hashes/0: must be 16 hexadecimal digits, was"
                                + " \"995bca2a5ba82fbX\""),
                Arguments.of(
                        "\"0\": \"995bca2a5ba82fbb\"",
                        "\"-1\": \"995bca2a5ba82fbb\"",
                        "15:13: /hashes: \"-1\" is no number of steps"),
                Arguments.of(
                        "\"0\": \"995bca2a5ba82fbb\"",
                        "\"99999999\": \"995bca2a5ba82fbb\"",
                        "16:17: /hashes/99999999: is beyond the 216000 steps of an hour, the most"
                                + " we play"),
                Arguments.of(
                        "\"0\": \"995bca2a5ba82fbb\"",
                        "\"269\": \"995bca2a5ba82fbb\"",
                        "17:5: /hashes/269: \"269\" is given twice (first at 16:5)"),
                Arguments.of(
                        "\"box\"},",
                        "\"box\"}",
                        "13:5: /clicks/0: not JSON: Unexpected character ('{' (code 123)): was"
                                + " expecting comma to separate Array entries"),
                Arguments.of(
                        "cb4ef448aff17123\"\n  }\n}\n",
                        "cb4ef",
                        "17:18: /hashes/269: not JSON: Unexpected end-of-input: was expecting"
                                + " closing quote for a string value"));
    }

    @ParameterizedTest
    @MethodSource("broken")
    void eachErrorIsToldAtItsPlaceAndNoOther(String sound, String broken, String expected) {
        assertThat(problems(with(sound, broken))).containsExactly("a.replay.json:" + expected);
    }

    @Test
    void nothingToCompareWithIsAnError() {
        int hashes = SOUND.indexOf("\"0\": ");
        assertThat(problems(SOUND.substring(0, hashes) + "}}"))
                .containsExactly(
                        "a.replay.json:15:13: /hashes: is empty: nothing tells whether it plays"
                                + " back the same");
    }

    @Test
    void whatIsWrongIsToldAllAtOnceInTheOrderOfTheFile() {
        String text =
                with("\"revision\": " + Pool.REVISION, "\"revision\": 99")
                        .replace(HASH, "0123456789abcdef")
                        .replace("\"substeps\": 4", "\"substeps\": 0")
                        .replace("\"step\": 130", "\"step\": 300");
        assertThat(problems(text))
                .extracting(line -> line.replaceFirst("^a\\.replay\\.json:\\d+:\\d+: ", ""))
                .containsExactly(
                        "/revision: " + OTHER_REVISION,
                        "/level/hash: the level \"drop\" was altered since this was played: its"
                                + " hash is "
                                + HASH
                                + " now, and was 0123456789abcdef",
                        "/accuracy/substeps: must be 1 or more, was 0",
                        "/clicks/1/step: is not before the end, which is at step 269");
    }

    @Test
    void aMissingAndAnEmptyFileAreTold() throws IOException {
        Path none = folder.resolve("none.replay.json");
        assertThat(words(loader.load(none)))
                .containsExactly(none + ": cannot be read: there is no such file");
        Path empty = Files.writeString(folder.resolve("empty.replay.json"), "");
        assertThat(words(loader.load(empty))).containsExactly(empty + ": the file is empty");
    }

    @Test
    void theSchemaKnowsEveryChoiceOfTheAccuracy() {
        Stream.<Enum<?>[]>of(
                        ImpactMode.values(),
                        ImpactSearch.values(),
                        Integrator.values(),
                        ContactSolver.values(),
                        Correction.values())
                .flatMap(Stream::of)
                .forEach(this::requireKnown);
    }

    private void requireKnown(Enum<?> choice) {
        Accuracy usual = Accuracy.GAME;
        Enum<?> present =
                Stream.<Enum<?>>of(
                                usual.impacts(),
                                usual.search(),
                                usual.integrator(),
                                usual.contactSolver(),
                                usual.correction())
                        .filter(one -> one.getDeclaringClass() == choice.getDeclaringClass())
                        .findFirst()
                        .orElseThrow();
        String text = with("\"" + present.name() + "\"", "\"" + choice.name() + "\"");
        assertThat(problems(text)).as("%s", choice).isEmpty();
    }
}
