package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.util.stream.Stream;

/** Whatever a level shows can be read, from its start to its end. */
class PuzzleLegibilityTest {

    /** Longer than any stored solution takes, in turns of 1/60 s. */
    private static final int LONGEST = 60 * 60;

    static Stream<SceneEntry> levels() {
        return Levels.entries().stream();
    }

    @ParameterizedTest
    @MethodSource("levels")
    void isLegibleFromTheStartToTheVictory(SceneEntry level) {
        Scene scene = open(level);
        Demonstration show = scene.demonstration().orElseThrow();
        for (int turn = 0; turn < LONGEST && !show.isOver(); turn++) {
            show.click().ifPresent(at -> scene.pointerPressed(PointerButton.LEFT, at.x(), at.y()));
            scene.step();
            if (turn % 60 == 0) {
                assertLegible(scene);
            }
        }
        assertThat(show.hasSucceeded()).isTrue();
        assertLegible(scene);
    }

    @ParameterizedTest
    @MethodSource("levels")
    void isLegiblePausedAndSlowed(SceneEntry level) {
        for (Key key : new Key[] {Key.P, Key.S}) {
            Scene scene = open(level);
            scene.keyPressed(key);
            scene.step();
            assertLegible(scene);
        }
    }

    private static Scene open(SceneEntry level) {
        return level.open().apply(new RecordingDirector());
    }

    private static void assertLegible(Scene scene) {
        assertThat(Legibility.faults(scene)).as(scene.title()).isEmpty();
    }
}
