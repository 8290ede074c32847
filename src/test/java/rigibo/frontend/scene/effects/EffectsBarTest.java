package rigibo.frontend.scene.effects;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Magnet;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sensors;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.backend.effect.Wind;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.trial.Trials;

import java.util.List;

class EffectsBarTest {

    private static final double TOP = 100;

    private static final Effects ALL =
            Effects.of(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new RollingResistance(),
                    new SurfaceSpeed(),
                    new Joints(),
                    new Sensors(),
                    new Drag(),
                    new AirDrag(1.2, 1.1),
                    new Wind(1, 0),
                    new Field(point -> point.push(1, 0)),
                    new CentralForce(0, 0, 1, 1),
                    new Fan(),
                    new Magnet(),
                    new Buoyancy(0, 1, 1),
                    new Thrust(),
                    new ContinuousImpacts(),
                    new Sleep());

    /** Costs are of no concern here: nothing is ever run. */
    private static EffectsBar bar(SceneEffects scene) {
        return new EffectsBar(scene, new CostMeter(Trials.on(trial -> {}, () -> 0)));
    }

    private static RecordingCanvas drawn(EffectsBar bar) {
        RecordingCanvas canvas = new RecordingCanvas();
        bar.draw(canvas, 8, TOP, Scene.WIDTH - 16);
        return canvas;
    }

    private static void click(EffectsBar bar, String words) {
        double[] middle = drawn(bar).middleOf(words);
        assertThat(bar.pointerPressed(middle[0], middle[1])).isTrue();
    }

    private static void leave(EffectsBar bar) {
        bar.pointerMoved(-1, -1);
    }

    @Test
    void showsWhatTheSceneCallsForFirstAndLit() {
        Effects calledFor = Effects.of(new Contacts(), new Restitution());
        RecordingCanvas canvas = drawn(bar(new Trough(calledFor)));
        assertThat(canvas.texts()).startsWith("contacts", "bounce", "gravity");
        assertThat(canvas.plateOf("contacts")).isEqualTo(Color.BRASS);
        assertThat(canvas.plateOf("gravity")).isEqualTo(Color.PANEL_LIT);
    }

    @Test
    void hasWordsForEveryKindOfEffectInTwoRows() {
        List<Class<?>> kinds = List.of(Effect.class.getPermittedSubclasses());
        assertThat(kinds).hasSameSizeAs(ALL.all()).hasSameSizeAs(KnownEffect.all());
        // No scene calls for all of them; two rows hold all but two.
        assertInTwoRows(ALL.without(Fan.class).without(Magnet.class));
        assertInTwoRows(ALL.without(Field.class).without(CentralForce.class));
    }

    private void assertInTwoRows(Effects called) {
        RecordingCanvas canvas = drawn(bar(new Trough(called)));
        for (Effect effect : called.all()) {
            double[] middle = canvas.middleOf(new Words("en").of("effect." + effect.title()));
            assertThat(middle[0]).isBetween(0.0, (double) Scene.WIDTH);
            assertThat(middle[1]).isBetween(TOP, TOP + 2 * Chip.HEIGHT + 2 * ChipLayout.GAP + 10);
        }
    }

    @Test
    void aClickSwitchesAnEffectMarksItAndBackAgain() {
        Trough scene = new Trough(Effects.of(new Gravity(0, -1.62), new Contacts()));
        EffectsBar bar = bar(scene);

        click(bar, "gravity");
        assertThat(scene.pool().effects().declares(Gravity.class)).isFalse();
        assertThat(drawn(bar).texts()).contains("experiment");
        leave(bar);
        assertThat(drawn(bar).texts()).contains(Trough.MARKING);
        assertThat(drawn(bar).framesRound("gravity")).isEqualTo(2);
        assertThat(drawn(bar).framesRound("contacts")).isEqualTo(1);

        click(bar, "gravity");
        leave(bar);
        assertThat(scene.pool().effects().find(Gravity.class)).contains(new Gravity(0, -1.62));
        assertThat(drawn(bar).texts()).doesNotContain(Trough.MARKING);
        assertThat(drawn(bar).framesRound("gravity")).isZero();
    }

    @Test
    void whatAnotherEffectNeedsStaysAndTheBarSaysWhy() {
        Trough scene = new Trough(Effects.of(new Contacts(), new Friction()));
        EffectsBar bar = bar(scene);

        click(bar, "contacts");

        assertThat(scene.pool().effects()).isEqualTo(scene.calledFor());
        String refusal = "friction needs contacts first";
        assertThat(drawn(bar).texts()).containsOnlyOnce(refusal).contains("a step takes …");
        leave(bar);
        assertThat(drawn(bar).texts()).doesNotContain(refusal);
    }

    @Test
    void windWithoutAirIsRefused() {
        Trough scene = new Trough(Effects.of(new Gravity(0, -9.81)));
        EffectsBar bar = bar(scene);
        click(bar, "wind");
        assertThat(drawn(bar).texts()).contains("wind needs drag or air drag first");
        click(bar, "air drag");
        click(bar, "wind");
        assertThat(scene.pool().effects().declares(Wind.class)).isTrue();
    }

    @Test
    void saysWhyInTheScenesOwnWords() {
        EffectReason held = new EffectReason(new Friction(), "crates hold each other");
        EffectReason water = new EffectReason(new Buoyancy(1, 2, 3), "the trough is full of water");
        Trough scene =
                new Trough(
                        Effects.of(new Gravity(0, -1), new Contacts(), new Friction()),
                        held,
                        water);
        EffectsBar bar = bar(scene);

        point(bar, "friction");
        assertThat(drawn(bar).texts()).contains("friction: crates hold each other");
        point(bar, "buoyancy");
        assertThat(drawn(bar).texts())
                .contains("buoyancy, if it were on: the trough is full of water");
        click(bar, "buoyancy");
        assertThat(scene.pool().effects().find(Buoyancy.class)).contains(new Buoyancy(1, 2, 3));
        assertThat(drawn(bar).texts()).contains("buoyancy, tried out: the trough is full of water");
        click(bar, "friction");
        assertThat(drawn(bar).texts()).contains("friction, left out: crates hold each other");
    }

    private static void point(EffectsBar bar, String words) {
        double[] middle = drawn(bar).middleOf(words);
        bar.pointerMoved(middle[0], middle[1]);
    }

    /** The longest that can be said of each, beside the mark of an experiment. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void whatIsSaidFitsIntoTheBar(String language) {
        Words words = new Words(language);
        RecordingCanvas canvas = new RecordingCanvas();
        double room = Scene.WIDTH - 2 * 22;
        for (KnownEffect known : KnownEffect.all()) {
            EffectReason reason = known.in(ALL, List.of(), words).orElseThrow();
            String title = words.of("effect." + reason.effect().title());
            String said = words.of("effect.offered", title, reason.words());
            assertThat(canvas.textWidth(said, 16, Canvas.Font.WORDS)).as(said).isLessThan(room);
        }
        Estimate unsure = new Estimate();
        unsure.add(-500_000);
        unsure.add(500_000);
        unsure.add(600_000);
        CostWords costs = new CostWords(words);
        String longest =
                words.of("cost.awake", costs.ofUnlit(unsure)) + "; " + costs.ofStep(9.99e6);
        double mark = canvas.textWidth(words.of("effect.experiment"), 16, Canvas.Font.WORDS);
        assertThat(canvas.textWidth(longest, 16, Canvas.Font.WORDS) + mark).isLessThan(room);
    }

    @Test
    void aPressBesideTheChipsIsTheBarsOwnAndChangesNothing() {
        Trough scene = new Trough(Effects.of(new Gravity(0, -9.81)));
        EffectsBar bar = bar(scene);
        drawn(bar);
        assertThat(bar.pointerPressed(20, TOP + EffectsBar.HEIGHT - 5)).isTrue();
        assertThat(bar.pointerPressed(20, TOP + EffectsBar.HEIGHT + 5)).isFalse();
        assertThat(scene.pool().effects()).isEqualTo(scene.calledFor());
    }
}
