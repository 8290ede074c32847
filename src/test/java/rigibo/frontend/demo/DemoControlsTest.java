package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.util.regex.Pattern;

/** The controls that all demos share. */
class DemoControlsTest {

    private static final Pattern STEPS = Pattern.compile(".*/step · .*");

    /** Plates begin folded, so that tabs and keys have something to do. */
    private static Scene open(int demo) {
        return Demos.entries().get(demo).open().apply(new RecordingDirector());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5})
    void dialIsTurnedByMouseAndKeysAndAlwaysThere(int demo) {
        Scene scene = open(demo);
        assertThat(RecordingCanvas.of(scene).plateOf("GAME")).isEqualTo(Color.BRASS);
        click(scene, "EXACT");
        scene.pointerMoved(-1, -1);
        scene.step();
        assertThat(RecordingCanvas.of(scene).plateOf("EXACT")).isEqualTo(Color.BRASS);
        scene.keyPressed(Key.DIGIT_1);
        assertThat(RecordingCanvas.of(scene).plateOf("DRAFT")).isEqualTo(Color.BRASS);
        assertThat(RecordingCanvas.of(scene).texts()).anyMatch(STEPS.asMatchPredicate());
    }

    /** The energy has a side of its own, which N and its tab turn up. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5})
    void energyUnfoldsByKeyAndTabAndCanBeRead(int demo) {
        Scene scene = open(demo);
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("potential");
        scene.keyPressed(Key.N);
        for (int second = 0; second < 3; second++) {
            assertThat(Legibility.faults(scene)).isEmpty();
            for (int i = 0; i < 60; i++) {
                scene.step();
            }
        }
        assertThat(RecordingCanvas.of(scene).texts())
                .contains("potential", "translational", "rotational");
        click(scene, "frame");
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("potential");
        click(scene, "energy");
        scene.keyPressed(Key.R);
        assertThat(RecordingCanvas.of(scene).texts()).contains("potential");
    }

    @Test
    void bracketsGoRoundTheDemos() {
        RecordingDirector director = new RecordingDirector();
        Scene first = Demos.entries().get(0).open().apply(director);
        first.keyPressed(Key.LEFT_BRACKET);
        Scene last = director.shown.get(0);
        last.keyPressed(Key.RIGHT_BRACKET);

        assertThat(last.title()).isEqualTo("RigiBo – " + "Car");
        assertThat(director.shown.get(1).title()).isEqualTo(first.title());
    }
}
