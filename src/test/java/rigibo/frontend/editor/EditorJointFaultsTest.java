package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.editor.TwoBoxes.erase;
import static rigibo.frontend.editor.TwoBoxes.joined;
import static rigibo.frontend.editor.TwoBoxes.problems;
import static rigibo.frontend.editor.TwoBoxes.withTwoBoxes;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.puzzle.level.LevelJoint;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;

import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.JsonNodeFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Faults of joints, and the sentences about them, in every language. */
class EditorJointFaultsTest {

    /** Width that an icon and margins leave for a line of the list of problems, px. */
    private static final double ROOM = DeskPlaces.PROBLEMS.width() - 16 - 22 - 8;

    /** Of the two lines in which a fault is told, each short of a word, px. */
    private static final double TWO_LINES = 2 * (DeskPlaces.FOOT.width() - 80);

    private static final List<Path> ROOMS =
            List.of(
                    Path.of("src/main/java/rigibo/frontend/puzzle"),
                    Path.of("src/main/java/rigibo/frontend/document"));

    @Test
    void whatMovesByNoForcesIsToldAtTheJoint() {
        Author author = Author.with(NewLevel.draft());
        author.take(LevelJoint.Type.WELD);
        author.clickWorld(2, 2);
        author.clickWorld(7, 1.2);
        assertThat(problems(author)).anyMatch(told -> told.startsWith("/joints/0 E118"));
        assertThat(author.look().texts()).contains("Moves nothing");
    }

    @Test
    void jointsWithoutTheirEffectAreTold() {
        Author author = joined(LevelJoint.Type.WELD);
        author.press("joints");
        assertThat(problems(author)).anyMatch(told -> told.contains("E119"));
        assertThat(author.look().texts()).contains("Joints not declared");
    }

    @Test
    void aRopeThatIsTooShortAndLimitsPastTheStartAreTold() {
        Author author = joined(LevelJoint.Type.ROPE);
        author.press(plain(Math.hypot(0.1, 1.6)));
        erase(author, 5);
        author.type("1");
        assertThat(problems(author)).anyMatch(told -> told.startsWith("/joints/0/length E122"));
        assertThat(author.look().texts()).contains("Rope too short");
        Author slide = joined(LevelJoint.Type.SLIDE);
        slide.press("Limits");
        slide.press("-1");
        erase(slide, 2);
        slide.type("0.5");
        assertThat(problems(slide)).anyMatch(told -> told.startsWith("/joints/0/limits E123"));
        assertThat(slide.look().texts()).contains("Begins past a limit");
        slide.clickWorld(6, 8);
        slide.press("Begins past a limit");
        assertThat(slide.look().texts()).contains("Slide");
    }

    private static String plain(double value) {
        return String.format(Locale.ROOT, "%.3f", value);
    }

    static Stream<String> languages() {
        return Settings.LANGUAGES.stream();
    }

    @ParameterizedTest
    @MethodSource("languages")
    void everyFieldOfEveryKindIsLegible(String language) {
        for (LevelJoint.Type type : LevelJoint.Type.values()) {
            Author author = withTwoBoxes(language);
            author.take(type);
            author.clickWorld(4.2, 5.8);
            author.clickWorld(4.3, 4.2);
            Words words = new Words(language);
            for (String part : List.of("limits", "motor", "springy")) {
                String name = words.of("editor.joint." + part);
                if (author.look().texts().contains(name)) {
                    author.press(name);
                }
                author.scene.step();
                assertThat(Legibility.faults(author.scene)).as(type + part).isEmpty();
                assertThat(author.look().texts()).noneMatch(text -> text.endsWith("…"));
            }
        }
    }

    /** A rule without words ended the editor as soon as a level broke it. */
    @ParameterizedTest
    @MethodSource("languages")
    void everyFaultHasANameAndASentenceInEveryLanguage(String language) throws IOException {
        Words words = new Words(language);
        RecordingCanvas canvas = withTwoBoxes().look();
        Set<String> kinds = kinds();
        assertThat(kinds).contains("E101", "E124.twice", "E153.par", "E160", "schema.required");
        for (String kind : kinds) {
            String name = words.of("editor.problem." + kind.replaceFirst("\\..*", ""));
            assertThat(canvas.textWidth(name, 16, Canvas.Font.WORDS)).as(name).isBetween(1.0, ROOM);
            String told = words.of("editor.problem." + kind + ".told", "a-body", "1000");
            assertThat(canvas.textWidth(told, 16, Canvas.Font.WORDS))
                    .as(told)
                    .isBetween(1.0, TWO_LINES);
        }
    }

    /** In a column a sentence has as many lines as it takes. */
    @ParameterizedTest
    @MethodSource("languages")
    void everySentenceIsWholeInAColumn(String language) throws IOException {
        Words words = new Words(language);
        Set<String> kinds = kinds();
        for (Layout layout : EditorInWideWindowsTest.LAYOUTS) {
            Area status = EditorInWideWindowsTest.places(layout, language).status();
            RecordingCanvas canvas = RecordingCanvas.of(withTwoBoxes().scene, layout);
            for (String kind : kinds) {
                String told = words.of("editor.problem." + kind + ".told", "a-body", "1000");
                double width = status.width() - 10;
                assertThat(Lines.of(canvas, told, 16, Canvas.Font.WORDS, width).size())
                        .as("lines of %s in %s", told, layout)
                        .isLessThanOrEqualTo((int) (status.height() / Pane.LINE));
            }
        }
    }

    /** Kinds of faults, as they stand in the sources. */
    private static Set<String> kinds() throws IOException {
        Pattern kind = Pattern.compile("\"((E\\d{3}|schema)(\\.[a-z]+)?)\"");
        Set<String> kinds = new TreeSet<>();
        for (Path room : ROOMS) {
            try (Stream<Path> files = Files.walk(room)) {
                for (Path source : files.filter(Files::isRegularFile).toList()) {
                    Matcher found = kind.matcher(Files.readString(source));
                    while (found.find()) {
                        kinds.add(found.group(1));
                    }
                }
            }
        }
        return kinds;
    }

    /** A damaged file says what is wrong with it; it does not end the editor. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "7",
                "{\"type\": 5}",
                "{\"type\": \"hinge\", \"a\": 3, \"b\": {}, \"at\": \"x\"}",
                "{\"type\": \"rope\", \"from\": [1, \"a\"], \"to\": [{}, 2]}",
                "{\"type\": \"weld\", \"at\": [1, 2], \"spring\": {\"hertz\": []}}",
                "{\"type\": \"hinge\", \"at\": [1, 2], \"limits\": [{}, \"x\"]}",
                "{\"type\": \"slide\", \"at\": [1, 2], \"motor\": {\"speed\": {}}}"
            })
    void aDamagedJointIsTold(String joint) {
        var node = new JsonMapper().readTree(joint);
        Draft draft =
                NewLevel.draft().with("/joints", JsonNodeFactory.instance.arrayNode().add(node));
        Author author = Author.with(draft);
        author.scene.keyPressed(Key.TAB);
        author.drag(2, 2, 3, 3);
        author.drag(1, 2, 2, 3);
        assertThat(problems(author)).anyMatch(told -> told.startsWith("/joints/0"));
    }
}
