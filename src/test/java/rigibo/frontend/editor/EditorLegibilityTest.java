package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.editor.desk.Leaf;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.Stream;

/** All texts of the editor can be read, in every language. */
class EditorLegibilityTest {

    /** A language, and a level in it. */
    record Page(String language, Path level) {}

    static Stream<Page> pages() {
        return Settings.LANGUAGES.stream()
                .flatMap(
                        language ->
                                LevelShelf.files().stream().map(file -> new Page(language, file)));
    }

    static Stream<String> languages() {
        return Settings.LANGUAGES.stream();
    }

    @ParameterizedTest
    @MethodSource("pages")
    void everyLevelAndEachOfItsPartsIsLegible(Page page) throws IOException {
        DraftFile opened = DraftFiles.open(page.level());
        Author author = new Author(opened, Optional.empty(), page.language());
        assertLegible(author);
        for (Item item : opened.draft().items()) {
            author.scene.keyPressed(Key.TAB);
            assertLegible(author);
        }
    }

    @ParameterizedTest
    @MethodSource("languages")
    void aDraftFullOfErrorsIsLegible(String language) {
        Draft draft = Author.with(draftFullOfErrors()).draft();
        Author author =
                new Author(new DraftFile(draft, Optional.empty()), Optional.empty(), language);
        assertLegible(author);
    }

    private static Draft draftFullOfErrors() {
        Draft draft = NewLevel.draft();
        for (int i = 0; i < 9; i++) {
            draft = draft.plus(draft.item("/bodies/0").orElseThrow().node());
        }
        return draft;
    }

    /** Each thing under the pointer tells what it is for, at the foot. */
    @ParameterizedTest
    @MethodSource("languages")
    void whatIsToldUnderThePointerIsLegible(String language) throws IOException {
        DraftFile opened = DraftFiles.open(LevelShelf.files().get(0));
        Author author = new Author(opened, Optional.empty(), language);
        author.look();
        for (double y = 8; y < Scene.HEIGHT; y += 12) {
            for (double x : new double[] {30, 160, 230, 340, 380, 500, 600, 700}) {
                author.scene.pointerMoved(x, y);
                assertLegible(author);
            }
        }
    }

    /** The leaves of the level, and of a body with all that it can have. */
    @ParameterizedTest
    @MethodSource("languages")
    void everyLeafIsLegible(String language) throws IOException {
        for (Path file : LevelShelf.files()) {
            DraftFile opened = DraftFiles.open(file);
            Author author = new Author(opened, Optional.empty(), language);
            Words words = new Words(language);
            for (Leaf leaf : Leaf.OF_LEVEL) {
                author.press(words.of("editor." + leaf.key()));
                assertLegible(author);
            }
            author.scene.keyPressed(Key.TAB);
            author.scene.keyPressed(Key.TAB);
            for (Leaf leaf : Leaf.OF_BODY) {
                author.press(words.of("editor." + leaf.key()));
                assertLegible(author);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("languages")
    void theListOfLevelsIsLegible(String language) throws IOException {
        DraftFile opened = DraftFiles.open(LevelShelf.files().get(0));
        Author author = new Author(opened, Optional.empty(), language);
        author.press(new Words(language).of("editor.open"));
        assertLegible(author);
    }

    /** The names of some files are longer than the head has room for. */
    private static Path shortestNamed() {
        return LevelShelf.files().stream()
                .min(Comparator.comparingInt(file -> file.getFileName().toString().length()))
                .orElseThrow();
    }

    @ParameterizedTest
    @MethodSource("languages")
    void nothingThatIsToldIsCutShort(String language) throws IOException {
        DraftFile opened = DraftFiles.open(shortestNamed());
        Author author = new Author(opened, Optional.empty(), language);
        RecordingCanvas canvas = author.look();
        assertThat(canvas.texts()).noneMatch(text -> text.endsWith("…"));
    }

    /** Without its sign, gravity of 9.81 would be one upwards. */
    @Test
    void enlargedNumbersKeepTheirSignAndTheMarkOfTheLanguage() {
        Author author =
                new Author(
                        new DraftFile(NewLevel.draft(), Optional.empty()), Optional.empty(), "de");
        Layout enlarged = Layout.ALONE.withText(1.3, 1.3);
        assertThat(RecordingCanvas.of(author.scene, enlarged).texts())
                .contains("-9,81", "Neues Level");
    }

    private static void assertLegible(Author author) {
        author.scene.step();
        assertThat(Legibility.faults(author.scene)).isEmpty();
    }
}
