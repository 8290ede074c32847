package rigibo.frontend.laboratory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.ghost.Parting;

/** Two accuracies side by side are the same scene, and tell the truth about each other. */
class LaboratorySceneTest {

    private static final Key[] EXPERIMENTS = {Key.DIGIT_1, Key.DIGIT_2, Key.DIGIT_3, Key.DIGIT_4};

    private static LaboratoryScene open(String experiment) {
        LaboratoryScene scene = new LaboratoryScene(new Words("en"));
        click(scene, experiment);
        return scene;
    }

    private static void click(LaboratoryScene scene, String words) {
        double[] at = RecordingCanvas.of(scene).middleOf(words);
        scene.pointerPressed(PointerButton.LEFT, at[0], at[1]);
        scene.pointerReleased(PointerButton.LEFT, at[0], at[1]);
    }

    private static void run(LaboratoryScene scene, int turns) {
        for (int i = 0; i < turns; i++) {
            scene.step();
        }
    }

    private static void assertEqual(LaboratoryScene scene) {
        assertThat(scene.left().pool().stateHash()).isEqualTo(scene.right().pool().stateHash());
    }

    @ParameterizedTest
    @ValueSource(strings = {"elastic balls", "stack", "heavy on light", "billiard"})
    void halvesStartEqualAndRBringsThemBack(String experiment) {
        LaboratoryScene scene = open(experiment);
        assertEqual(scene);
        long start = scene.left().pool().stateHash();
        run(scene, 90);
        assertThat(scene.left().pool().stateHash()).isNotEqualTo(start);

        scene.keyPressed(Key.R);

        assertEqual(scene);
        assertThat(scene.left().pool().stateHash()).isEqualTo(start);
        assertThat(scene.divergence().distance()).isZero();
    }

    @ParameterizedTest
    @ValueSource(strings = {"elastic balls", "stack", "heavy on light", "billiard"})
    void equalAccuraciesStayEqualToTheLastBit(String experiment) {
        LaboratoryScene scene = open(experiment);
        scene.left().choose(Preset.EXACT);
        run(scene, 300);
        assertEqual(scene);
        assertThat(scene.divergence().distance()).isZero();
    }

    @Test
    void switchChangesItsHalfAlone() {
        LaboratoryScene scene = open("stack");
        run(scene, 30);
        long state = scene.right().pool().stateHash();

        click(scene, "GAME");

        assertThat(scene.left().preset()).isEqualTo(Preset.FINE);
        assertThat(scene.left().pool().accuracy()).isEqualTo(Preset.FINE.accuracy());
        assertThat(scene.right().preset()).isEqualTo(Preset.EXACT);
        assertThat(scene.right().pool().accuracy()).isEqualTo(Preset.EXACT.accuracy());
        assertThat(scene.right().pool().stateHash()).isEqualTo(state);
    }

    @Test
    void switchGoesRoundThePresets() {
        LaboratoryScene scene = open("stack");
        for (String name : new String[] {"EXACT", "DRAFT", "FINE"}) {
            assertThat(RecordingCanvas.of(scene).texts()).contains(scene.right().preset().name());
            scene.keyPressed(Key.RIGHT);
        }
        assertThat(scene.right().preset()).isEqualTo(Preset.FINE);
    }

    /** Billiard balls double an error at each collision; a stack's error only adds up. */
    @Test
    void billiardIsChaoticAndTheStackIsNot() {
        LaboratoryScene billiard = open("billiard");
        run(billiard, 900);
        assertThat(billiard.divergence().parting()).map(Parting::isChaotic).contains(true);
        assertThat(RecordingCanvas.of(billiard).texts())
                .anyMatch(words -> words.startsWith("chaotic: after "));

        LaboratoryScene stack = open("stack");
        run(stack, 900);
        assertThat(stack.divergence().parting()).isEmpty();
        assertThat(RecordingCanvas.of(stack).texts())
                .noneMatch(words -> words.startsWith("chaotic"));
    }

    /** Each of some hundred impacts rounds the energy by some bits. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void elasticBallsKeepTheirEnergy(Preset preset) {
        LaboratoryScene scene = open("elastic balls");
        scene.left().choose(preset);
        run(scene, 600);
        assertThat(scene.left().energyShare()).isCloseTo(1, within(1e-12));
    }

    @Test
    void aPausedSceneStandsStillAndGoesOnStepByStep() {
        LaboratoryScene scene = open("billiard");
        scene.keyPressed(Key.SPACE);
        long state = scene.left().pool().stateHash();
        run(scene, 10);
        assertThat(scene.left().pool().stateHash()).isEqualTo(state);
        scene.keyPressed(Key.PERIOD);
        assertThat(scene.left().pool().stateHash()).isNotEqualTo(state);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everythingCanBeReadAtAnyTime(String language) {
        for (Key experiment : EXPERIMENTS) {
            for (Preset preset : Preset.values()) {
                LaboratoryScene scene = new LaboratoryScene(new Words(language));
                scene.keyPressed(experiment);
                scene.left().choose(preset);
                for (int second = 0; second < 10; second += 2) {
                    assertThat(Legibility.faults(scene)).as(experiment + " " + preset).isEmpty();
                    run(scene, 120);
                }
            }
        }
    }
}
