package rigibo.frontend.gallery;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.touch;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The gallery, used as a player does, with everything that the game ships in it. */
class GalleryTest {

    /** With plates beside the exhibit. */
    private static final Layout WIDE = Layout.of(1280, 800, 1).withColumns();

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    private final RecordingDirector director = new RecordingDirector();

    static List<Found> exhibits() {
        return Exhibits.all();
    }

    private Scene shown() {
        return director.shown.get(director.shown.size() - 1);
    }

    private static void press(Scene scene, Key... keys) {
        for (Key key : keys) {
            scene.keyPressed(key);
        }
    }

    @Test
    void everyExhibitHasANameOfItsOwnAmongAllScenes() {
        Set<String> names = new HashSet<>();
        assertThat(exhibits()).isNotEmpty().allMatch(found -> names.add(found.name()));
    }

    @ParameterizedTest
    @MethodSource("exhibits")
    void namesTheFileThatItIsWrittenInAndSaysWhatItShows(Found found) {
        assertThat(HOME.resolve(found.source())).isRegularFile();
        ExhibitWords english = new ExhibitWords(new Words("en"));
        ExhibitWords german = new ExhibitWords(new Words("de"));
        assertThat(english.about(found)).as("words of %s", found.name()).isNotEmpty();
        assertThat(german.about(found)).isNotEmpty().isNotEqualTo(english.about(found));
    }

    /** At its start, at work and paused. */
    @ParameterizedTest
    @MethodSource("exhibits")
    void runsAndCanBeReadInBothLanguages(Found found) {
        for (String language : List.of("en", "de")) {
            Scene scene = new ExhibitScene(new RecordingDirector(language), found);
            assertThat(Legibility.faults(scene)).isEmpty();
            for (int i = 0; i < 30; i++) {
                scene.step();
            }
            scene.keyPressed(Key.SPACE);
            assertThat(Legibility.faults(scene)).isEmpty();
            assertThat(Legibility.faults(scene, WIDE)).isEmpty();
            assertThat(Legibility.faultsInHand(scene)).isEmpty();
            assertThat(RecordingCanvas.of(scene).texts()).contains(found.source());
        }
    }

    /** In wide windows nothing lies over an exhibit, and T hides what lies over it in others. */
    @Test
    void platesStandBesideAnExhibitOrAreHiddenByAKey() {
        Found found = Exhibits.all().get(0);
        Scene scene = new ExhibitScene(new RecordingDirector(), found);
        RecordingCanvas wide = RecordingCanvas.of(scene, WIDE);
        assertThat(wide.middleOf("GAME")[0]).isNegative();
        for (int y = 4; y < Scene.HEIGHT; y += 8) {
            assertThat(wide.isUnderPanel(Scene.WIDTH / 2.0, y)).as("at %s", y).isFalse();
        }
        assertThat(RecordingCanvas.of(scene).isUnderPanel(Scene.WIDTH / 2.0, 50)).isTrue();
        scene.keyPressed(Key.T);
        assertThat(RecordingCanvas.of(scene).isUnderPanel(Scene.WIDTH / 2.0, 50)).isFalse();
    }

    /** Every exhibit runs the same way again: it uses no clock and no random number. */
    @ParameterizedTest
    @MethodSource("exhibits")
    void goesTheSameWayEachTime(Found found) {
        long[] ends = new long[2];
        for (int i = 0; i < 2; i++) {
            Exhibit exhibit = found.make().get();
            Pool pool = exhibit.open();
            exhibit.run(pool, 0.25);
            ends[i] = pool.stateHash();
        }
        assertThat(ends[0]).isEqualTo(ends[1]);
    }

    /** Each page by the walk that the tour takes, and each card of it under the pointer. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everyPageOfEverySectionCanBeRead(String language) {
        RecordingDirector told = new RecordingDirector(language);
        ExhibitWords words = new ExhibitWords(told.words());
        Scene scene = new GalleryScene(told, Optional.empty());
        Demonstration walk = scene.demonstration().orElseThrow();
        Set<String> seen = new HashSet<>();
        while (!walk.isOver()) {
            walk.click().ifPresent(at -> scene.pointerPressed(PointerButton.LEFT, at.x(), at.y()));
            if (walk.picture().isPresent()) {
                assertThat(Legibility.faults(scene)).isEmpty();
                seen.addAll(RecordingCanvas.of(scene).texts());
            }
        }
        assertThat(seen).containsAll(exhibits().stream().map(words::title).toList());
        RecordingCanvas canvas = new RecordingCanvas();
        assertThat(exhibits())
                .allMatch(
                        found -> canvas.textWidth(words.about(found), 17, Canvas.Font.WORDS) < 656);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everyPageCanBeReadAndTouchedInAHand(String language) {
        RecordingDirector told = new RecordingDirector(language);
        Scene scene = new GalleryScene(told, Optional.empty());
        for (Layout layout : Legibility.hands(scene)) {
            RecordingCanvas.of(scene, layout);
            Set<String> seen = new HashSet<>();
            while (seen.addAll(RecordingCanvas.of(scene, layout).texts())) {
                assertThat(Legibility.faults(scene, layout)).isEmpty();
                touch(scene, layout, "›");
            }
            GalleryPlaces places = GalleryPlaces.of(layout, 3);
            assertThat(
                            Stream.of(
                                    places.back(),
                                    places.tabs().first(),
                                    places.pagers().first(),
                                    places.cards().first()))
                    .allMatch(at -> Math.min(at.width(), at.height()) * layout.ratio() > 43.99);
        }
    }

    @Test
    void anExhibitIsUsedByButtonsInAHand() {
        for (Layout layout : Legibility.HANDS) {
            RecordingDirector director = new RecordingDirector();
            director.hasAddress = true;
            Scene scene = new ExhibitScene(director, exhibits().get(0));
            assertThat(Legibility.tooSmallForFingers(scene, layout)).isEmpty();
            touch(scene, layout, "Pause");
            assertThat(RecordingCanvas.of(scene, layout).texts()).contains("paused");
            touch(scene, layout, "more");
            assertThat(Legibility.faults(scene, layout)).isEmpty();
            touch(scene, layout, "GAME");
            assertThat(RecordingCanvas.of(scene, layout).texts()).contains("FINE");
            touch(scene, layout, "link");
            assertThat(director.asked).containsExactly("share");
            touch(scene, layout, "Gallery");
            assertThat(director.shown).hasSize(1);
        }
    }

    /** The page of samples is right about what hangs here, and forgets none. */
    @Test
    void thePageOfSamplesNamesWhatHangsHere() throws IOException {
        String page = Files.readString(HOME.resolve("docs/samples.md"));
        List<String> rows =
                page.lines()
                        .dropWhile(line -> !line.equals("## Box2D v3"))
                        .filter(line -> line.startsWith("| ") && !line.contains("| sample |"))
                        .toList();
        assertThat(rows).hasSize(139 + 23);
        Set<String> named = new HashSet<>();
        Matcher names = Pattern.compile("gallery: `([a-z-]+)`").matcher(String.join("\n", rows));
        int count = 0;
        while (names.find()) {
            named.add(names.group(1));
            count++;
        }
        assertThat(page).contains("| hang in the gallery | " + count + " |");
        assertThat(named).allMatch(name -> Exhibits.named(name).isPresent());
        List<String> samples =
                exhibits().stream()
                        .filter(found -> !found.section().equals("examples"))
                        .map(Found::name)
                        .toList();
        assertThat(named).containsAll(samples);
    }

    @Test
    void theMenuLeadsToItAndACardOpensAnExhibit() {
        SceneEntry door = Gallery.entry();
        Scene gallery = door.open().apply(director);
        double[] at = RecordingCanvas.of(gallery).middleOf("Carrying cup");
        gallery.pointerMoved(at[0], at[1]);
        gallery.pointerPressed(PointerButton.LEFT, at[0], at[1]);
        assertThat(shown().title()).isEqualTo("RigiBo – Carrying cup");
        press(gallery, Key.UP, Key.UP, Key.ENTER);
        assertThat(director.shown).hasSize(1);
    }

    @Test
    void escGoesBackToTheCardThatWasChosen() {
        Found last = exhibits().get(exhibits().size() - 1);
        Scene scene = new ExhibitScene(director, last);
        assertThat(scene.escaped()).isTrue();
        press(shown(), Key.ENTER);
        assertThat(shown().title()).isEqualTo(scene.title());
        assertThat(new GalleryScene(director, Optional.empty()).escaped()).isFalse();
    }

    @Test
    void bracketsGoRoundAllExhibits() {
        Scene first = new ExhibitScene(director, exhibits().get(0));
        press(first, Key.LEFT_BRACKET);
        press(shown(), Key.RIGHT_BRACKET);
        assertThat(director.shown.get(0).title()).isNotEqualTo(first.title());
        assertThat(shown().title()).isEqualTo(first.title());
    }

    @Test
    void onlyTheChosenCardMoves() {
        Scene gallery = Gallery.entry().open().apply(director);
        List<double[]> before = RecordingCanvas.of(gallery).bodies();
        for (int i = 0; i < 60; i++) {
            gallery.step();
        }
        List<double[]> after = RecordingCanvas.of(gallery).bodies();
        List<Integer> moved =
                IntStream.range(0, before.size())
                        .filter(i -> Math.abs(before.get(i)[1] - after.get(i)[1]) > 1)
                        .boxed()
                        .toList();
        // The lift is the first card: it, what is on it and what is beside it are seven.
        assertThat(moved).isNotEmpty().allMatch(i -> i < 7);
    }

    @Test
    void aBodyIsDraggedAndFlungAndTheSceneHaltsStepsAndBeginsAnew() {
        Scene scene = new ExhibitScene(director, Exhibits.named("moving-lift").orElseThrow());
        double[] start = crate(scene);
        scene.pointerPressed(PointerButton.LEFT, start[0], start[1]);
        scene.pointerMoved(start[0] + 100, start[1] - 100);
        for (int i = 0; i < 20; i++) {
            scene.step();
        }
        double[] pulled = crate(scene);
        // 12/s of the way left for a third of a second: all but e^(−4) of it.
        assertThat(pulled[0] - start[0]).isBetween(90.0, 101.0);
        scene.pointerReleased(PointerButton.LEFT, pulled[0], pulled[1]);
        press(scene, Key.SPACE);
        scene.step();
        assertThat(crate(scene)).containsExactly(pulled);
        press(scene, Key.PERIOD);
        assertThat(crate(scene)).isNotEqualTo(pulled);
        press(scene, Key.R);
        assertThat(crate(scene)).containsExactly(start);
    }

    /** The fourth body that is added. */
    private static double[] crate(Scene scene) {
        return RecordingCanvas.of(scene).bodies().get(3);
    }

    @Test
    void accuracyIsChosenByDigits() {
        Scene scene = new ExhibitScene(director, exhibits().get(0));
        assertThat(RecordingCanvas.of(scene).texts()).contains("GAME");
        press(scene, Key.DIGIT_4);
        assertThat(RecordingCanvas.of(scene).texts()).contains("EXACT");
    }

    /** Names and words are made of the class alone where nobody wrote any. */
    @Test
    void anExhibitOfAStrangerNeedsNoWords() {
        Found strange = new Found(OneBall.class, OneBall::new);
        assertThat(strange.name()).isEqualTo("one-ball");
        assertThat(new ExhibitWords(new Words("de")).title(strange)).isEqualTo("OneBall");
        Scene scene = new ExhibitScene(director, strange);
        scene.step();
        scene.keyPressed(Key.S);
        assertThat(Legibility.faults(scene)).isEmpty();
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("source", "1 / 1");
    }

    /** A ball that falls. */
    static final class OneBall implements Exhibit {

        @Override
        public void build(Pool pool) {
            pool.add(BodyDefinition.dynamic(new Circle(0.2)));
        }
    }
}
