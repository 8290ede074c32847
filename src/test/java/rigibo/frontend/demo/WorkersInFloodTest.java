package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Choice;
import rigibo.frontend.scene.widget.Readout;
import rigibo.frontend.scene.widget.Widget;

import java.util.List;

/** The flood's switch for workers, and the figures it shows. */
class WorkersInFloodTest {

    /** Above it a step of one worker no longer fits into a frame. */
    private static final int HELD_BY_ONE = 500;

    private static final int MOST_STEPS = 3000;

    /** A flood of its own on a machine with a number of processors. */
    private static final class Running {
        final FloodDemo demo;
        final Workbench bench;
        final List<Widget> widgets;
        int heldByOne = HELD_BY_ONE;
        long now;

        Running(int processors) {
            demo = new FloodDemo(new Words("en"), processors);
            bench = new Workbench(demo.effects(), demo.camera());
            demo.build(bench);
            widgets = demo.widgets();
        }

        void step() {
            demo.beforeStep(bench);
            bench.step(Scene.STEP);
            demo.afterStep(bench);
        }

        <W extends Widget> W find(Class<W> kind) {
            return widgets.stream().filter(kind::isInstance).map(kind::cast).findFirst().get();
        }

        String told(String words) {
            return widgets.stream()
                    .filter(Readout.class::isInstance)
                    .map(Readout.class::cast)
                    .filter(readout -> readout.words().equals(words))
                    .findFirst()
                    .get()
                    .value()
                    .get();
        }

        /** Lets steps take as long as their bodies by their workers, not as a clock tells. */
        void timeByBodies() {
            bench.pool().clock(this::tick);
        }

        private long tick() {
            double share = bench.pool().bodies().size() / (double) heldByOne;
            now += (long) (share / bench.pool().workers() * FrameTimes.BUDGET_MILLIS * 1e6 / 8);
            return now;
        }
    }

    @Test
    void switchTakesEffectWithTheNextStepAndChangesNoBit() {
        Running alone = new Running(3);
        Running changing = new Running(3);
        for (int step = 0; step < 150; step++) {
            if (step % 50 == 49) {
                changing.find(Choice.class).nudge(1);
            }
            alone.step();
            changing.step();
            assertThat(changing.bench.pool().workers()).isEqualTo(1 + (step + 1) / 50 % 3);
            assertThat(changing.bench.pool().stateHash())
                    .as("after step %d", step)
                    .isEqualTo(alone.bench.pool().stateHash());
        }
        changing.bench.close();
    }

    @Test
    void goesUpToEightWorkers() {
        assertThat(new Running(8).find(Choice.class).options()).hasSize(8);
        assertThat(new Running(64).find(Choice.class).options()).hasSize(8);
    }

    @Test
    void saysThatThereIsOneProcessor() {
        Running one = new Running(1);
        assertThat(one.widgets).noneMatch(Choice.class::isInstance);
        assertThat(one.told("workers")).isEqualTo("one processor");
    }

    /** Twice the workers take half the time by the test's clock. */
    @Test
    void tellsTheTimesOfBothOnceTheyAreMeasured() {
        Running flood = new Running(2);
        flood.timeByBodies();
        for (int step = 0; step < 240; step++) {
            flood.step();
        }
        flood.find(Choice.class).nudge(1);
        flood.step();
        assertThat(flood.told("by workers")).matches("1 +2");
        assertThat(flood.told("step p50, ms")).endsWith("–");
        for (int step = 0; step < 120; step++) {
            flood.step();
        }
        String[] medians = flood.told("step p50, ms").split(" +");
        assertThat(Double.parseDouble(medians[0]) / Double.parseDouble(medians[1]))
                .isBetween(1.9, 2.1);
        flood.bench.close();
    }

    @Test
    void searchTellsTheMostBodiesOfBoth() {
        Running flood = new Running(2);
        flood.timeByBodies();
        flood.find(Choice.class).nudge(1);
        flood.find(Button.class).action().run();
        for (int step = 0; step < MOST_STEPS && !isFound(flood); step++) {
            flood.step();
        }
        String[] held = flood.told("60 Hz, physics").split(" +");
        assertThat(Integer.parseInt(held[0])).isPositive();
        assertThat(Integer.parseInt(held[1]) / Double.parseDouble(held[0])).isBetween(1.5, 2.5);
        assertThat(flood.bench.pool().workers()).isEqualTo(2);
        flood.bench.close();
    }

    @Test
    void searchSaysWhereNoNumberOfBodiesIsHeld() {
        Running flood = new Running(1);
        flood.timeByBodies();
        flood.heldByOne = 1;
        assertThat(flood.told("60 Hz, physics")).isEqualTo("–");
        flood.find(Button.class).action().run();
        for (int step = 0; step < MOST_STEPS && flood.told("60 Hz, physics").equals("–"); step++) {
            flood.step();
        }
        assertThat(flood.told("60 Hz, physics")).isEqualTo("none");
        flood.bench.close();
    }

    private static boolean isFound(Running flood) {
        return flood.told("60 Hz, physics").matches("\\d+ +\\d+");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void figuresOfBothAreLegible(String language) {
        DemoScene scene =
                new DemoScene(new RecordingDirector(language), words -> new FloodDemo(words, 8));
        scene.keyPressed(Key.C);
        assertThat(Legibility.faults(scene)).isEmpty();
        click(scene, new Words(language).of("flood.workers"));
        for (int step = 0; step < 60; step++) {
            scene.step();
        }
        click(scene, new Words(language).of("flood.search"));
        for (int part = 0; part < 8; part++) {
            assertThat(Legibility.faults(scene)).isEmpty();
            for (int step = 0; step < 20; step++) {
                scene.step();
            }
        }
        assertThat(RecordingCanvas.of(scene).texts()).anyMatch(text -> text.matches("1 +8"));
        scene.closed();
    }
}
