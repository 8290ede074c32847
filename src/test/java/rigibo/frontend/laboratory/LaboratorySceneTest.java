package rigibo.frontend.laboratory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.frontend.scene.Pointing.click;
import static rigibo.frontend.scene.Pointing.touch;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingNarrator;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.ghost.Parting;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Two accuracies side by side are the same scene, and tell the truth about each other. */
class LaboratorySceneTest {

    private static final Key[] EXPERIMENTS = {Key.DIGIT_1, Key.DIGIT_2, Key.DIGIT_3, Key.DIGIT_4};

    @TempDir private Path folder;

    private static LaboratoryScene open(String experiment) {
        LaboratoryScene scene = new LaboratoryScene(new RecordingDirector("en"));
        click(scene, experiment);
        scene.left().choose(Preset.GAME);
        return scene;
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
    void itsButtonsCanBeUsedByName() {
        LaboratoryScene scene = open("stack");
        RecordingCanvas.of(scene);
        RecordingNarrator told = RecordingNarrator.of(scene);
        assertThat(told.control("stack").kind()).isEqualTo(Control.Kind.ON);
        RecordingNarrator.press(scene, told.control("Right half: EXACT"));
        assertThat(scene.right().preset()).isEqualTo(Preset.DRAFT);
    }

    @Test
    void opensWithPresetsThatVisiblyPart() {
        LaboratoryScene scene = new LaboratoryScene(new RecordingDirector("en"));
        assertThat(scene.left().preset()).isEqualTo(Preset.DRAFT);
        assertThat(scene.right().preset()).isEqualTo(Preset.EXACT);
        run(scene, 180);
        assertThat(scene.divergence().distance()).as("m after 3 s").isGreaterThan(0.2);
    }

    @Test
    void slidersSetAnAccuracyOfTheirOwn() {
        LaboratoryScene scene = open("stack");
        click(scene, "Expert");
        double[] label = RecordingCanvas.of(scene).middleOf("substeps of a step");
        scene.pointerPressed(PointerButton.LEFT, 700, label[1]);
        scene.pointerMoved(690, label[1]);
        scene.pointerReleased(PointerButton.LEFT, 690, label[1]);
        assertThat(scene.right().accuracy().substeps()).isGreaterThan(50);
        assertThat(scene.right().pool().accuracy()).isEqualTo(scene.right().accuracy());
        assertThat(scene.left().accuracy()).isEqualTo(Preset.GAME.accuracy());
        assertThat(RecordingCanvas.of(scene).texts()).contains("OWN");
        scene.keyPressed(Key.RIGHT);
        assertThat(scene.right().isOwn()).isFalse();
    }

    @Test
    void tablesAndPicturesAreSavedIntoNewFilesAndToldOf() throws IOException {
        RecordingDirector director = new RecordingDirector("en");
        director.measurements = Optional.of(folder.resolve("measurements"));
        LaboratoryScene scene = new LaboratoryScene(director);
        run(scene, 3);
        click(scene, "CSV");
        click(scene, "CSV");
        Path second = folder.resolve("measurements/billiard-2.csv");
        List<String> lines = Files.readAllLines(second);
        assertThat(lines.get(0)).startsWith("# billiard; left: Accuracy[substeps=1,");
        assertThat(lines.get(1)).startsWith("time_s,distance_m,left_energy_percent,right_energy");
        assertThat(lines).hasSize(2 + 3);
        assertThat(lines.get(4)).startsWith("0.0500,");
        assertThat(lines.get(4).split(",")).hasSameSizeAs(lines.get(1).split(","));
        assertThat(String.join("", RecordingCanvas.of(scene).texts())).contains("billiard-2.csv");
        click(scene, "Picture");
        assertThat(director.pictures)
                .containsExactly(folder.resolve("measurements/billiard-1.png"));
        run(scene, 180);
        assertThat(scene.divergence().parting()).as("which is told where files are").isPresent();
        scene.keyPressed(Key.X);
        RecordingCanvas.of(scene);
        scene.keyPressed(Key.C);
        assertThat(String.join("", RecordingCanvas.of(scene).texts())).contains("billiard-3.csv");
    }

    @Test
    void aPlayerWithoutFilesIsToldThatNothingIsSaved() {
        LaboratoryScene scene = open("stack");
        click(scene, "CSV");
        assertThat(RecordingCanvas.of(scene).texts())
                .contains("Not saved: this player keeps no files");
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
    void everyDrawerCanBeRead(String language) {
        RecordingDirector director = new RecordingDirector(language);
        director.measurements = Optional.of(folder.resolve("measurements"));
        LaboratoryScene scene = new LaboratoryScene(director);
        for (int drawer = 0; drawer < Quantity.values().length; drawer++) {
            scene.keyPressed(Key.G);
            assertThat(Legibility.faults(scene)).isEmpty();
            run(scene, 100);
            assertThat(Legibility.faultsInHand(scene)).isEmpty();
            assertThat(Legibility.faults(scene)).isEmpty();
        }
        scene.keyPressed(Key.X);
        assertThat(Legibility.faults(scene)).isEmpty();
        scene.keyPressed(Key.G);
        scene.keyPressed(Key.C);
        assertThat(Legibility.faults(scene)).isEmpty();
    }

    @Test
    void isUsedByButtonsInAHand() {
        RecordingDirector director = new RecordingDirector("en");
        LaboratoryScene scene = new LaboratoryScene(director);
        for (Layout layout : Legibility.hands(scene)) {
            Preset before = scene.left().preset();
            touch(scene, layout, before.name());
            assertThat(scene.left().preset()).isEqualTo(before.next());
            run(scene, 10);
            touch(scene, layout, "Restart");
            assertThat(scene.left().pool().time()).isZero();
            touch(scene, layout, "Pause");
            run(scene, 1);
            assertThat(scene.left().pool().time()).isZero();
            touch(scene, layout, "Pause");
            touch(scene, layout, "stack");
            touch(scene, layout, "Overlap");
            assertThat(RecordingCanvas.of(scene, layout).texts())
                    .as("on its button and above the graph")
                    .filteredOn("Overlap"::equals)
                    .hasSize(2);
            touch(scene, layout, "Menu");
        }
        assertThat(director.asked).hasSize(Legibility.HANDS.size()).containsOnly("menu");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void everythingCanBeReadAtAnyTime(String language) {
        for (Key experiment : EXPERIMENTS) {
            for (Preset preset : Preset.values()) {
                LaboratoryScene scene = new LaboratoryScene(new RecordingDirector(language));
                scene.keyPressed(experiment);
                scene.left().choose(preset);
                for (int second = 0; second < 10; second += 2) {
                    assertThat(Legibility.faults(scene)).as(experiment + " " + preset).isEmpty();
                    assertThat(Legibility.faultsInHand(scene))
                            .as(experiment + " " + preset)
                            .isEmpty();
                    for (Layout layout : Legibility.hands(scene)) {
                        assertThat(Legibility.tooSmallForFingers(scene, layout)).isEmpty();
                    }
                    run(scene, 120);
                }
            }
        }
    }
}
