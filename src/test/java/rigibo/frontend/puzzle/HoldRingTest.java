package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.RecordingCanvas;

import java.util.List;

class HoldRingTest {

    private final HoldRing ring = new HoldRing();

    private List<RecordingCanvas.Ring> drawn() {
        RecordingCanvas canvas = new RecordingCanvas();
        ring.draw(canvas, 100, 100, 28, true);
        return canvas.rings();
    }

    @Test
    void isNotThereBeforeTheBallIsOnThePlatform() {
        ring.step(0);
        assertThat(drawn()).isEmpty();
    }

    @Test
    void fillsAsTheHoldGoesOn() {
        ring.step(0.25);
        assertThat(drawn()).anyMatch(arc -> arc.fraction() == 0.25);
    }

    @Test
    void whatWasHeldIsSeenToFlyApartWhenTheBallLeaves() {
        ring.step(0.6);
        ring.step(0);
        assertThat(drawn()).hasSize(1).allMatch(arc -> arc.fraction() == 0.6);
        assertThat(drawn().get(0).color().red()).isEqualTo(Color.BAD.red());
        for (int i = 0; i < 60; i++) {
            ring.step(0);
        }
        assertThat(drawn()).isEmpty();
    }

    @Test
    void fliesNowhereWhereLessIsToMove() {
        ring.step(0.6);
        ring.step(0);
        RecordingCanvas canvas = new RecordingCanvas();
        ring.draw(canvas, 100, 100, 28, false);
        assertThat(canvas.rings()).isEmpty();
    }
}
