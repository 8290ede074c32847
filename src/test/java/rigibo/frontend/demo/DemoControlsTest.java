package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.util.List;

/** The controls that all demos share. */
class DemoControlsTest {

    private final RecordingCanvas canvas = new RecordingCanvas();

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

    /** The first chip is gravity; it goes out, is marked as an experiment, and comes back. */
    @Test
    void chipSwitchesAnEffectAndBack() {
        Effects calledFor = Effects.of(new Gravity(0, -1.62), new Contacts());
        Pool pool = new Pool(calledFor, Accuracy.GAME);
        EffectsBar bar = new EffectsBar(pool);
        bar.draw(canvas);
        double[] gravity = canvas.middleOf("gravity");

        assertThat(bar.pointerPressed(gravity[0], gravity[1])).isTrue();
        assertThat(pool.effects().declares(Gravity.class)).isFalse();
        bar.pointerMoved(0, 0);
        assertThat(words(bar)).anyMatch(words -> words.startsWith("an experiment"));

        bar.pointerPressed(gravity[0], gravity[1]);
        assertThat(pool.effects().find(Gravity.class)).contains(new Gravity(0, -1.62));
        bar.pointerMoved(0, 0);
        assertThat(words(bar)).noneMatch(words -> words.startsWith("an experiment"));
    }

    @Test
    void whatAnotherEffectNeedsStaysAndTheBarSaysWhy() {
        Pool pool = new Pool(Effects.of(new Contacts(), new Friction()), Accuracy.GAME);
        EffectsBar bar = new EffectsBar(pool);
        bar.draw(canvas);
        double[] contacts = canvas.middleOf("contacts");

        bar.pointerPressed(contacts[0], contacts[1]);

        assertThat(pool.effects().declares(Contacts.class)).isTrue();
        assertThat(words(bar)).anyMatch(words -> words.contains("Contacts"));
    }

    private static List<String> words(EffectsBar bar) {
        RecordingCanvas now = new RecordingCanvas();
        bar.draw(now);
        return now.texts();
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
