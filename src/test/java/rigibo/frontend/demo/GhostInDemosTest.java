package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.Preset;
import rigibo.frontend.scene.ghost.Ghost;
import rigibo.frontend.scene.widget.Slider;

import java.util.function.Function;

/** A ghost goes along with a demo, whatever is done to that, and changes nothing in it. */
@Execution(ExecutionMode.CONCURRENT)
class GhostInDemosTest {

    private static final double STEP = 1.0 / 60;
    private static final int STEPS = 300;

    /**
     * At the scene's own accuracy a ghost is the scene, to the bit, if what hand, motor, blast and
     * hose do to the one reaches the other, too.
     */
    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void ghostAtTheSameAccuracyStaysInTheScene(Function<Words, Demo> maker) {
        Demo demo = maker.apply(new Words("en"));
        Workbench bench = EveryDemo.built(demo);
        bench.haunt(new Ghost(bench.pool(), Preset.GAME));
        drive(demo, bench);
        assertThat(bench.ghost().divergence().distance()).isZero();
    }

    /** And at another one it is not, in the end. */
    @Test
    void ghostAtAnotherAccuracyParts() {
        Demo demo = new CrateDemo(new Words("en"));
        Workbench bench = EveryDemo.built(demo);
        bench.haunt(true);
        drive(demo, bench);
        assertThat(bench.ghost().preset()).isEqualTo(Preset.FINE);
        assertThat(bench.ghost().divergence().distance()).isPositive();
    }

    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void sceneDoesNotFeelItsGhost(Function<Words, Demo> maker) {
        Demo plain = maker.apply(new Words("en"));
        Workbench alone = EveryDemo.built(plain);
        drive(plain, alone);
        Demo haunted = maker.apply(new Words("en"));
        Workbench bench = EveryDemo.built(haunted);
        bench.haunt(true);
        drive(haunted, bench);
        assertThat(bench.pool().stateHash()).isEqualTo(alone.pool().stateHash());
    }

    /** G turns up the ghost's side; the dial begins another ghost; G again ends it. */
    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void ghostIsTurnedUpByKeyAndCanBeRead(Function<Words, Demo> maker) {
        Scene scene = new DemoScene(new RecordingDirector(), maker);
        scene.keyPressed(Key.G);
        for (int second = 0; second < 3; second++) {
            assertThat(Legibility.faults(scene)).isEmpty();
            for (int i = 0; i < 60; i++) {
                scene.step();
            }
        }
        assertThat(RecordingCanvas.of(scene).texts()).contains("from FINE");
        scene.keyPressed(Key.DIGIT_4);
        scene.step();
        assertThat(RecordingCanvas.of(scene).texts()).contains("from GAME");
        scene.keyPressed(Key.R);
        assertThat(RecordingCanvas.of(scene).texts()).contains("from FINE");
        scene.keyPressed(Key.G);
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("from FINE");
        scene.closed();
    }

    /** Five seconds of all that can be done to a demo by hand. */
    private static void drive(Demo demo, Workbench bench) {
        demo.widgets().stream()
                .filter(Slider.class::isInstance)
                .map(Slider.class::cast)
                .filter(slider -> slider.label().equals("torque"))
                .forEach(slider -> slider.change().accept(20));
        for (int step = 0; step < STEPS; step++) {
            if (step == 60) {
                RigidBody body = firstThatMoves(bench);
                bench.grab(body.x(), body.y());
            }
            if (step == 90) {
                bench.letGo();
                demo.key(bench, Key.B);
                demo.rightClick(bench, 0, 6);
            }
            bench.point(bench.pointerX() + 0.02, bench.pointerY() + 0.03);
            bench.pull();
            demo.beforeStep(bench);
            bench.step(STEP);
            demo.afterStep(bench);
        }
    }

    private static RigidBody firstThatMoves(Workbench bench) {
        return bench.pool().bodies().stream()
                .filter(body -> body.type() == BodyType.DYNAMIC)
                .findFirst()
                .orElseThrow();
    }
}
