package rigibo.frontend.editor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.editor.desk.Leaf;
import rigibo.frontend.editor.draft.Item;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.editor.file.DraftFile;
import rigibo.frontend.editor.file.DraftFiles;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingNarrator;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Tap;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The editor in a handheld window, used by fingers alone. */
class EditorInHandTest {

    /** Every n-th level is enough. */
    private static final int EVERY = 7;

    private static final List<String> TABS = List.of("build", "fields", "effects", "more");

    static Stream<String> languages() {
        return Settings.LANGUAGES.stream();
    }

    /** Someone who holds an editor. */
    private static final class Holder {

        private final RecordingDirector director;
        private final EditorScene scene;
        private final Layout layout;

        Holder(DraftFile draft, String language, Layout hand) {
            director = new RecordingDirector(language);
            scene = new EditorScene(director, draft);
            layout = hand.sheet();
            look();
        }

        RecordingCanvas look() {
            scene.step();
            return RecordingCanvas.of(scene, layout);
        }

        void tab(String key) {
            press(director.words().of("editor.hand." + key));
        }

        Control control(String start) {
            look();
            return RecordingNarrator.of(scene).controls().stream()
                    .filter(control -> control.name().startsWith(start))
                    .findFirst()
                    .orElseThrow(() -> new AssertionError("no " + start));
        }

        void use(String start) {
            look();
            RecordingNarrator.press(scene, control(start));
            scene.pointerMoved(-1000, -1000);
        }

        void take(String tool) {
            tab("build");
            use(tool);
        }

        /** Turns the pages of fields until one has a control. */
        void turnTo(String start) {
            for (int page = 0; page < 9; page++) {
                if (RecordingNarrator.of(scene).names().stream().anyMatch(start::equals)) {
                    return;
                }
                press("›");
            }
        }

        /** Drags a finger from one point of the world to another, m. */
        void drag(double fromX, double fromY, double toX, double toY) {
            double[] from = seen(fromX, fromY);
            double[] to = seen(toX, toY);
            assertThat(scene.tap(from[0], from[1])).isEqualTo(Tap.AT_ONCE);
            scene.pointerMoved(from[0], from[1]);
            scene.pointerPressed(PointerButton.LEFT, from[0], from[1]);
            scene.pointerMoved((from[0] + to[0]) / 2, (from[1] + to[1]) / 2);
            scene.pointerMoved(to[0], to[1]);
            scene.pointerReleased(PointerButton.LEFT, to[0], to[1]);
            scene.pointerMoved(-1000, -1000);
            look();
        }

        /** Where a point of the world is, by where the new level's ball and platform are. */
        private double[] seen(double x, double y) {
            Control ball = control("Ball");
            Control platform = control("Platform");
            double scale = (platform.x() - ball.x()) / 5;
            return new double[] {
                ball.x() + ball.width() / 2 + scale * (x - 2),
                ball.y() + ball.height() / 2 - scale * (y - 2.55)
            };
        }

        void press(String name) {
            double[] at = look().firstMiddleOf(name);
            touch(at[0], at[1]);
        }

        void touch(double x, double y) {
            assertThat(scene.tap(x, y)).isIn(Tap.LIFTED, Tap.AT_ONCE);
            scene.pointerMoved(x, y);
            scene.pointerPressed(PointerButton.LEFT, x, y);
            scene.pointerReleased(PointerButton.LEFT, x, y);
            scene.pointerMoved(-1000, -1000);
            look();
        }

        void assertInOrder(String where) {
            look();
            assertThat(Legibility.faults(scene, layout)).as(where + layout).isEmpty();
            assertThat(Legibility.tooSmallForFingers(scene, layout)).as(where + layout).isEmpty();
        }
    }

    private static DraftFile fresh() {
        return new DraftFile(NewLevel.draft(), Optional.empty());
    }

    @ParameterizedTest
    @MethodSource("languages")
    void everyDrawerCanBeReadAndTouched(String language) {
        for (Layout hand : Legibility.HANDS) {
            Holder holder = new Holder(fresh(), language, hand);
            holder.assertInOrder("shut");
            assertThat(holder.look().texts()).noneMatch(text -> text.endsWith("…"));
            for (String tab : TABS) {
                holder.tab(tab);
                holder.assertInOrder(tab);
                assertThat(holder.look().texts()).noneMatch(text -> text.endsWith("…"));
            }
        }
    }

    /** All fields of all things of some levels of each world, page after page. */
    @ParameterizedTest
    @MethodSource("languages")
    void everyPageOfFieldsCanBeReadAndTouched(String language) throws IOException {
        List<Path> files = LevelShelf.files();
        for (int i = 0; i < files.size(); i += EVERY) {
            Path file = files.get(i);
            DraftFile opened = DraftFiles.open(file);
            for (Layout hand : List.of(Legibility.HANDS.get(0), Legibility.HANDS.get(2))) {
                Holder holder = new Holder(opened, language, hand);
                holder.tab("fields");
                assertPages(holder, Leaf.OF_LEVEL);
                for (Item item : opened.draft().items()) {
                    holder.scene.keyPressed(Key.TAB);
                    if (item.kind() == Item.Kind.BODY) {
                        assertPages(holder, Leaf.OF_BODY);
                    }
                }
            }
        }
    }

    private static void assertPages(Holder holder, List<Leaf> leaves) {
        for (Leaf leaf : leaves) {
            holder.press(holder.director.words().of("editor." + leaf.key()));
            List<String> before = List.of();
            for (List<String> now = holder.look().texts(); !now.equals(before); ) {
                holder.assertInOrder(leaf.key());
                before = now;
                if (now.contains("›")) {
                    holder.press("›");
                }
                now = holder.look().texts();
            }
        }
    }

    /** Fingers can do everything, from an empty level to a test and back. */
    @Test
    void aLevelOfAHingeAndARopeIsMadeByTouches() {
        for (Layout hand : Legibility.HANDS) {
            Holder holder = new Holder(fresh(), "en", hand);
            holder.take("Box");
            holder.drag(4, 5, 5, 6);
            holder.take("Rope");
            holder.drag(4.5, 5.5, 4.5, 8);
            holder.tab("fields");
            holder.turnTo("On a click +");
            holder.use("On a click +");
            holder.tab("fields");
            holder.take("Box");
            holder.drag(5.5, 3, 7.5, 3.3);
            holder.take("Hinge");
            holder.drag(6, 3.15, 6, 3.15);
            holder.drag(6, 3.15, 6, 3.15);
            assertThat(holder.scene.draft().at("/joints/0/type").asString()).isEqualTo("rope");
            assertThat(holder.scene.draft().at("/joints/0/click").asString()).isEqualTo("cut");
            assertThat(holder.scene.draft().at("/joints/1/type").asString()).isEqualTo("hinge");
            assertThat(new LevelLoader().parse("draft", holder.scene.draft().toString()).problems())
                    .isEmpty();

            holder.use("Test");

            assertThat(holder.scene.isSheet()).isFalse();
            assertThat(RecordingNarrator.of(holder.scene).names())
                    .anyMatch(name -> name.startsWith("Rope, to be cut, middle"));
            holder.scene.escaped();
            holder.use("Undo");
            assertThat(holder.scene.draft().at("/joints")).hasSize(1);
        }
    }

    /** Pointed corners would take all touches of something as small as a finger. */
    @Test
    void aSmallThingIsDraggedByItsMiddle() {
        Holder holder = new Holder(fresh(), "en", Legibility.HANDS.get(0));
        holder.take("Disc");
        holder.drag(4, 5, 4.2, 5);
        holder.take("Choose");
        holder.drag(4, 5, 5, 6);
        assertThat(holder.scene.draft().lastBody().place().x()).isBetween(4.9, 5.1);
        assertThat(holder.scene.draft().lastBody().form().reach()).isBetween(0.15, 0.25);
    }

    @Test
    void aFingerThatHoldsNothingMovesTheView() {
        Holder holder = new Holder(fresh(), "en", Legibility.HANDS.get(0));
        Control before = holder.control("Ball");
        holder.drag(5, 8, 6, 8);
        assertThat(holder.control("Ball").x()).isGreaterThan(before.x() + 10);
        holder.tab("more");
        holder.use("See all of it");
        assertThat(holder.control("Ball").x()).isEqualTo(before.x());
    }

    @Test
    void twoFingersEnlargeTheDraftAndOneDrawsInItWhereItPoints() {
        Holder holder = new Holder(fresh(), "en", Legibility.HANDS.get(1));
        double[] middle = holder.seen(4.5, 5);
        holder.scene.pinched(new Pinch(2, middle[0], middle[1], 0, 0));
        double[] now = holder.seen(4.5, 5);
        assertThat(now[0]).isCloseTo(middle[0], within(1e-6));
        assertThat(now[1]).isCloseTo(middle[1], within(1e-6));
        holder.take("Box");
        holder.drag(4, 5, 5, 6);
        assertThat(holder.scene.draft().lastBody().place().x()).isCloseTo(4.5, within(0.026));
        assertThat(holder.scene.draft().lastBody().place().y()).isCloseTo(5.5, within(0.026));
    }

    /** The first of two fingers comes down a little earlier. */
    @Test
    void aSecondFingerTakesBackWhatTheFirstBegan() {
        for (String tool : List.of("Box", "Polygon", "Another ball", "Hinge", "Choose")) {
            Holder holder = new Holder(fresh(), "en", Legibility.HANDS.get(0));
            holder.take(tool);
            String before = holder.scene.draft().toString();
            List<String> drawn = holder.look().texts();
            double[] ball = holder.seen(2, 2.55);
            holder.scene.pointerMoved(ball[0], ball[1]);
            holder.scene.pointerPressed(PointerButton.LEFT, ball[0], ball[1]);
            holder.scene.pointerMoved(ball[0] + 30, ball[1] - 30);
            holder.scene.interrupted();
            holder.scene.pointerReleased(PointerButton.LEFT, ball[0] + 30, ball[1] - 30);
            assertThat(holder.scene.draft().toString()).as(tool).isEqualTo(before);
            assertThat(holder.look().texts()).as(tool).isEqualTo(drawn);
        }
    }

    @Test
    void whatIsTypedIsShownAboveTheKeyboard() {
        Holder holder = new Holder(fresh(), "en", Legibility.HANDS.get(0));
        holder.tab("fields");
        holder.use("Title New level");
        assertThat(holder.scene.isTyping()).isTrue();
        "!".codePoints().forEach(holder.scene::typed);
        double[] at = holder.look().firstMiddleOf("New level!|");
        assertThat(holder.look().middleOf("OK")[1]).isLessThan(holder.layout.height() / 4);
        assertThat(at).isNotNull();
        holder.use("OK");
        assertThat(holder.scene.draft().at("/title/en").asString()).isEqualTo("New level!");
    }

    @Test
    void theWayBackShutsTheDrawerFirst() {
        Holder holder = new Holder(fresh(), "en", Legibility.HANDS.get(2));
        holder.tab("effects");
        holder.use("Back");
        assertThat(holder.director.asked).isEmpty();
        holder.use("Back");
        assertThat(holder.director.asked).containsExactly("menu");
    }
}
