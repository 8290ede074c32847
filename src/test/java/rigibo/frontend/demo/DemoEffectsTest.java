package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Effect;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.function.Function;

/** The effects bar of each demo. */
class DemoEffectsTest {

    /** Titles of all chips that any demo shows. */
    private static final List<String> TITLES =
            List.of(
                    "gravity",
                    "contacts",
                    "rotation",
                    "friction",
                    "restitution",
                    "rolling-resistance",
                    "surface-speed",
                    "thrust",
                    "joints",
                    "continuous-impacts",
                    "sleep",
                    "air-drag",
                    "wind");

    /** A demo with its effects bar, which is opened where plates have one column only. */
    private static Scene open(Function<Words, Demo> maker) {
        Scene scene = new DemoScene(new RecordingDirector(), maker);
        if (chips(RecordingCanvas.of(scene, EveryDemo.WIDE)).isEmpty()) {
            scene.keyPressed(Key.E);
        }
        return scene;
    }

    private static List<String> chips(RecordingCanvas canvas) {
        return TITLES.stream().filter(title -> canvas.texts().contains(name(title))).toList();
    }

    private static String name(String title) {
        return new Words("en").of("effect." + title);
    }

    private static List<String> lit(Scene scene) {
        RecordingCanvas canvas = RecordingCanvas.of(scene, EveryDemo.WIDE);
        return chips(canvas).stream()
                .filter(title -> canvas.plateOf(name(title)).equals(Color.BRASS))
                .toList();
    }

    private static List<String> declared(Function<Words, Demo> maker) {
        return maker.apply(new Words("en")).effects().all().stream().map(Effect::title).toList();
    }

    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void litIsWhatTheDemoDeclares(Function<Words, Demo> maker) {
        assertThat(lit(open(maker))).hasSameElementsAs(declared(maker));
    }

    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void saysInItsOwnWordsWhyItCallsForEach(Function<Words, Demo> maker) {
        Demo demo = maker.apply(new Words("en"));
        assertThat(demo.reasons())
                .extracting(reason -> reason.effect().title())
                .doesNotHaveDuplicates()
                .containsAll(declared(maker));
    }

    /**
     * Whichever effects are switched, the demo goes on and can be read, and R restores its own set.
     */
    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void everyEffectCanBeTriedAndRRestoresTheSet(Function<Words, Demo> maker) {
        Scene scene = open(maker);
        for (String chip : chips(RecordingCanvas.of(scene, EveryDemo.WIDE))) {
            click(scene, EveryDemo.WIDE, name(chip));
            for (int i = 0; i < 30; i++) {
                scene.step();
            }
            assertThat(Legibility.faults(scene, EveryDemo.WIDE)).as(chip).isEmpty();
            scene.keyPressed(Key.R);
            assertThat(lit(scene)).as(chip).hasSameElementsAs(declared(maker));
        }
    }

    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void aSwitchedEffectIsMarkedUntilItIsBack(Function<Words, Demo> maker) {
        Scene scene = open(maker);
        click(scene, EveryDemo.WIDE, "gravity");
        scene.pointerMoved(-1, -1);
        assertThat(RecordingCanvas.of(scene, EveryDemo.WIDE).texts())
                .anyMatch(words -> words.startsWith("an experiment"));
        click(scene, EveryDemo.WIDE, "gravity");
        scene.pointerMoved(-1, -1);
        assertThat(RecordingCanvas.of(scene, EveryDemo.WIDE).texts())
                .noneMatch(words -> words.startsWith("an experiment"));
    }
}
