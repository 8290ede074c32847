package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.editor.pane.Area;
import rigibo.frontend.editor.pane.Pane;
import rigibo.frontend.editor.pane.Spots;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingNarrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** In wide windows the draft has the whole height, and everything else stands beside it. */
class EditorInWideWindowsTest {

    private static final Layout WIDE = Layout.of(1366, 768, 1);

    /** Of every shape that has columns, the narrowest too, with larger text. */
    static final List<Layout> LAYOUTS =
            List.of(
                    Layout.of(860, 800, 1),
                    Layout.of(1000, 800, 1).withText(1.3, 1.3),
                    Layout.of(1024, 768, 1),
                    Layout.of(1000, 680, 1),
                    Layout.of(1280, 800, 1),
                    Layout.of(1280, 800, 1).withText(1.3, 1.3),
                    WIDE,
                    WIDE.withText(1.15, 1.3),
                    WIDE.withText(1.3, 1.3),
                    Layout.of(2560, 1080, 1));

    private final Draft fresh = NewLevel.draft();
    private final EditorScene scene = of(new DraftFile(fresh, Optional.empty()), "en");

    static Stream<String> languages() {
        return Settings.LANGUAGES.stream();
    }

    private static EditorScene of(DraftFile draft, String language) {
        EditorScene scene = new EditorScene(new RecordingDirector(language), draft);
        scene.step();
        return scene;
    }

    static DeskPlaces places(Layout layout, String language) {
        RecordingCanvas canvas = RecordingCanvas.of(new Empty(), layout);
        Pane pane = new Pane(canvas, new Spots(), new Words(language), 0, 0);
        return DeskPlaces.of(pane, List.of());
    }

    /** Draws nothing. */
    private static final class Empty implements Scene {

        @Override
        public String title() {
            return "";
        }

        @Override
        public void step() {}

        @Override
        public void draw(Canvas canvas) {}
    }

    @Test
    void theDraftHasTheWholeHeight() {
        for (Layout layout : List.of(Layout.of(1280, 800, 1), WIDE, Layout.of(1920, 1080, 1))) {
            Area draft = places(layout, "en").draft();
            assertThat(draft.height()).isEqualTo(layout.height());
            assertThat(draft.width()).isGreaterThanOrEqualTo(Scene.WIDTH);
        }
    }

    @ParameterizedTest
    @MethodSource("languages")
    void platesLieInTheWindowAndMeetNeitherEachOtherNorTheDraft(String language) {
        for (Layout layout : LAYOUTS) {
            DeskPlaces places = places(layout, language);
            List<Area> all = new ArrayList<>(places.plates());
            all.addAll(List.of(places.fields(), places.problems(), places.draft()));
            Area window = new Area(layout.left(), layout.top(), layout.width(), layout.height());
            assertThat(places.isBeside()).isTrue();
            for (Area one : all) {
                assertThat(isWithin(one, window)).as(one + " " + layout).isTrue();
                assertThat(all.stream().filter(other -> meet(one, other))).containsExactly(one);
            }
        }
    }

    private static boolean isWithin(Area inner, Area outer) {
        return outer.contains(inner.x(), inner.y())
                && outer.contains(inner.right(), inner.bottom());
    }

    private static boolean meet(Area one, Area other) {
        return one.x() < other.right()
                && other.x() < one.right()
                && one.y() < other.bottom()
                && other.y() < one.bottom();
    }

    @Test
    void nothingMovesWhereColumnsWouldMakeTheDraftSmaller() {
        List<Layout> narrow = List.of(Layout.ALONE, Layout.of(612, 680, 1), Layout.of(850, 800, 1));
        for (Layout layout : narrow) {
            assertThat(places(layout, "en").draft()).isEqualTo(DeskPlaces.DRAFT);
        }
    }

    @ParameterizedTest
    @MethodSource("languages")
    void everyLevelAndEachOfItsPartsIsLegible(String language) throws IOException {
        for (Path file : LevelShelf.files()) {
            DraftFile opened = DraftFiles.open(file);
            EditorScene edited = of(opened, language);
            assertLegible(edited);
            for (Item item : opened.draft().items()) {
                edited.keyPressed(Key.TAB);
                edited.step();
                assertLegible(edited);
            }
        }
    }

    private static void assertLegible(EditorScene edited) {
        for (Layout layout : LAYOUTS) {
            assertThat(Legibility.faults(edited, layout)).as("in %s", layout).isEmpty();
        }
    }

    /** What a tool, a button or a chip is for has as many lines as it takes. */
    @ParameterizedTest
    @MethodSource("languages")
    void nothingThatIsToldUnderThePointerIsCutShort(String language) {
        EditorScene edited = of(new DraftFile(fresh, Optional.empty()), language);
        for (Layout layout : LAYOUTS) {
            RecordingCanvas.of(edited, layout);
            List<Control> controls = RecordingNarrator.of(edited).controls();
            assertThat(controls).hasSizeGreaterThan(50);
            for (Control control : controls) {
                edited.pointerMoved(
                        control.x() + control.width() / 2, control.y() + control.height() / 2);
                assertThat(Legibility.faults(edited, layout)).as("in %s", layout).isEmpty();
                assertThat(RecordingCanvas.of(edited, layout).texts())
                        .as("at %s in %s", control.name(), layout)
                        .noneMatch(text -> text.endsWith("…"));
            }
        }
    }

    @Test
    void aBoxIsDrawnDraggedTakenBackAndPlayed() {
        use("Box:");
        drag(4, 5, 5, 6);
        use("Choose,");
        drag(4.5, 5.5, 6.5, 7.5);
        assertThat(number("/bodies/1/x")).isCloseTo(6.5, within(1e-9));
        use("Undo");
        assertThat(number("/bodies/1/x")).isCloseTo(4.5, within(1e-9));
        use("Test");
        assertThat(scene.isSheet()).as("in the editor").isFalse();
        scene.escaped();
        use("Undo");
        assertThat(scene.draft()).isEqualTo(fresh);
    }

    private double number(String pointer) {
        return scene.draft().at(pointer).asDouble(Double.NaN);
    }

    private void look() {
        scene.step();
        RecordingCanvas.of(scene, WIDE);
    }

    private void use(String start) {
        look();
        Control control =
                RecordingNarrator.of(scene).controls().stream()
                        .filter(it -> it.name().startsWith(start))
                        .findFirst()
                        .orElseThrow(() -> new AssertionError("no " + start));
        RecordingNarrator.press(scene, control);
    }

    private void drag(double fromX, double fromY, double toX, double toY) {
        look();
        var camera = View.camera(fresh, places(WIDE, "en").draft());
        double x = camera.screenX(toX);
        double y = camera.screenY(toY);
        scene.pointerPressed(PointerButton.LEFT, camera.screenX(fromX), camera.screenY(fromY));
        scene.pointerMoved(x, y);
        scene.pointerReleased(PointerButton.LEFT, x, y);
    }
}
