package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.util.List;

/** The controls that all demos share. */
class DemoControlsTest {

    @ParameterizedTest
    @EnumSource(AccuracyDial.Preset.class)
    void dialChoosesThePresetUnderThePointer(AccuracyDial.Preset preset) {
        Pool pool = new Pool();
        AccuracyDial dial = new AccuracyDial(pool, 100, 10);
        double segment = StageProfile.WIDTH / AccuracyDial.Preset.values().length;

        boolean isOn = dial.pointerPressed(100 + (preset.ordinal() + 0.5) * segment, 20);

        assertThat(isOn).isTrue();
        assertThat(pool.accuracy())
                .isEqualTo(
                        List.of(Accuracy.DRAFT, Accuracy.GAME, Accuracy.FINE, Accuracy.EXACT)
                                .get(preset.ordinal()));
    }

    @Test
    void besideTheDialNothingIsChosen() {
        Pool pool = new Pool();
        assertThat(new AccuracyDial(pool, 100, 10).pointerPressed(99, 20)).isFalse();
        assertThat(pool.accuracy()).isEqualTo(Accuracy.GAME);
    }

    @Test
    void bracketsGoRoundTheDemos() {
        RecordingDirector director = new RecordingDirector();
        Scene first = Demos.entries().get(0).open().apply(director);
        first.keyPressed(Key.LEFT_BRACKET);
        Scene last = director.shown.get(0);
        last.keyPressed(Key.RIGHT_BRACKET);

        assertThat(last.title()).isEqualTo("RigiBo – " + Demos.entries().get(3).title());
        assertThat(director.shown.get(1).title()).isEqualTo(first.title());
    }
}
