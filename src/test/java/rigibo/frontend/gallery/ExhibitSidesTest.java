package rigibo.frontend.gallery;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.touch;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.Link;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** The plates beside an exhibit: its source, the time of a frame, its ghost. */
class ExhibitSidesTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    /** With room for a source beside the exhibit. */
    private static final Layout WIDE = Layout.of(1280, 800, 1).withSource();

    /** More pages than any source has. */
    private static final int MANY = 40;

    private final Found lift = Exhibits.named("moving-lift").orElseThrow();

    static List<Found> exhibits() {
        return Exhibits.all();
    }

    private static Scene open(Found found) {
        return new ExhibitScene(new RecordingDirector(), found);
    }

    /** The number of the page, which is drawn last. */
    private static String page(List<String> texts) {
        return texts.stream()
                .filter(any -> any.matches("\\d+ / \\d+"))
                .reduce((one, next) -> next)
                .orElseThrow();
    }

    private static String letters(String text) {
        return text.replaceAll("\\s", "");
    }

    /** All that is written from the first comment on, whatever lines are broken. */
    @ParameterizedTest
    @MethodSource("exhibits")
    void theSourceIsReadBesideTheExhibitInWideWindows(Found found) throws IOException {
        Scene scene = open(found);
        StringBuilder read = new StringBuilder();
        Set<String> pages = new HashSet<>();
        for (int i = 0; i < MANY; i++) {
            assertThat(Legibility.faults(scene, WIDE)).isEmpty();
            List<String> texts = RecordingCanvas.of(scene, WIDE).texts();
            String page = page(texts);
            if (pages.add(page)) {
                // It is drawn after the tabs, of which the ghost's is the last.
                int begin = texts.indexOf("ghost") + 1;
                read.append(String.join("", texts.subList(begin, texts.lastIndexOf(page))));
            }
            scene.scrolled(-1, WIDE.sourceLeft() + 20, 780);
        }
        String written =
                Files.readAllLines(HOME.resolve(found.source())).stream()
                        .dropWhile(line -> !line.startsWith("/**"))
                        .collect(Collectors.joining());
        assertThat(letters(read.toString())).isNotEmpty().isEqualTo(letters(written));
    }

    @Test
    void theSourceIsBehindATabInAHand() {
        for (Layout layout : Legibility.HANDS) {
            Scene scene = open(lift);
            assertThat(RecordingCanvas.of(scene, layout).texts()).noneMatch(this::isItsClass);
            touch(scene, layout, "source");
            assertThat(Legibility.faults(scene, layout)).isEmpty();
            assertThat(pagesOf(scene, layout)).anyMatch(this::isItsClass);
            touch(scene, layout, "source");
            assertThat(RecordingCanvas.of(scene, layout).texts()).noneMatch(this::isItsClass);
        }
    }

    private Set<String> pagesOf(Scene scene, Layout layout) {
        Set<String> all = new HashSet<>();
        for (int i = 0; i < MANY; i++) {
            List<String> texts = RecordingCanvas.of(scene, layout).texts();
            all.addAll(texts);
            String page = page(texts);
            touch(scene, layout, page);
        }
        return all;
    }

    private boolean isItsClass(String line) {
        return line.contains("class MovingLift");
    }

    @Test
    void framesAndGhostsAreReadInEveryWindow() {
        for (String language : List.of("en", "de")) {
            for (Key key : List.of(Key.F, Key.G, Key.S)) {
                Scene scene = new ExhibitScene(new RecordingDirector(language), lift);
                scene.keyPressed(key);
                scene.step();
                assertThat(Legibility.faults(scene)).isEmpty();
                assertThat(Legibility.faults(scene, WIDE)).isEmpty();
                assertThat(Legibility.faultsInHand(scene)).isEmpty();
            }
        }
    }

    /** It does to the ghost's bodies what it does to its own, and so does a hand. */
    @ParameterizedTest
    @MethodSource("exhibits")
    void everyExhibitGoesOnWithAGhost(Found found) {
        Scene scene = open(found);
        scene.keyPressed(Key.G);
        for (int i = 0; i < 40; i++) {
            scene.step();
            if (i == 10) {
                scene.pointerPressed(PointerButton.RIGHT, 360, 400);
                scene.pointerReleased(PointerButton.RIGHT, 360, 400);
            }
            if (i == 20) {
                double[] body = RecordingCanvas.of(scene).bodies().get(0);
                scene.pointerPressed(PointerButton.LEFT, body[0], body[1]);
            }
        }
        scene.pointerReleased(PointerButton.LEFT, 360, 400);
        scene.step();
        assertThat(RecordingCanvas.of(scene).texts()).contains(new Words("en").of("ghost.rms"));
    }

    /** The platform rises by metres: a ghost that it does not carry stays as far behind. */
    @Test
    void theGhostIsCarriedAsItsSceneIs() {
        Showing showing = new Showing(lift.make().get());
        showing.haunt(lift.make().get());
        double before = showing.pool().bodies().get(3).y();
        double highest = before;
        for (int i = 0; i < 120; i++) {
            showing.step();
            highest = Math.max(highest, showing.pool().bodies().get(3).y());
        }
        assertThat(highest - before).isGreaterThan(0.5);
        assertThat(showing.ghost().orElseThrow().divergence().distance()).isLessThan(0.01);
    }

    @Test
    void aLinkOpensTheGhost() {
        Scene scene = open(lift);
        assertThat(scene.follow(Link.of("moving-lift?ghost=on&accuracy=fine"))).isTrue();
        scene.step();
        assertThat(scene.link()).isEqualTo(Link.of("moving-lift?accuracy=fine&ghost=on"));
        assertThat(RecordingCanvas.of(scene).texts())
                .contains(new Words("en").of("ghost.from", "EXACT"));
    }
}
