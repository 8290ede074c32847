package rigibo.frontend.puzzle.show;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.PlayedLevel;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingCanvas.Ring;
import rigibo.frontend.scene.Settings.Motion;

import java.util.List;

/** The ring around the ball: 3 s of hold fill it, and the lost part stays visible for a moment. */
class HoldRingTest {

    /** Radius for the ball of 0.35 m at 80 px/m, and its gap. */
    private static final double RADIUS = 0.35 * 80 + 8;

    private static final int LOST_TURNS = 36;

    private static final double PANEL_FOOT = 300;

    /** The filled share of the ring. */
    private static double held(RecordingCanvas canvas) {
        return canvas.rings().stream()
                .filter(ring -> Math.abs(ring.radius() - RADIUS) < 1e-9)
                .filter(ring -> ring.color().equals(Color.GOOD))
                .mapToDouble(Ring::fraction)
                .findFirst()
                .orElse(0);
    }

    /** The opacities of the lost pieces; the panel of a lost try is far above them. */
    private static List<Float> pieces(RecordingCanvas canvas) {
        return canvas.lines().stream()
                .filter(line -> line.y1() > PANEL_FOOT)
                .map(RecordingCanvas.Line::color)
                .filter(color -> color.alpha(1).equals(Color.BAD))
                .map(Color::alpha)
                .toList();
    }

    /** Plays while the ball is on the platform. */
    private static PlayedLevel untilItIsLost(Motion motion) {
        PlayedLevel played = new PlayedLevel(PlayedLevel.rollingOff(), "en", motion);
        while (pieces(played.canvas()).isEmpty()) {
            played.turns(1);
        }
        return played;
    }

    @Test
    void fillsEvenlyInThreeSeconds() {
        PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());
        played.clickBox();
        while (held(played.canvas()) == 0) {
            played.turns(1);
        }
        double first = held(played.canvas());
        played.turns(90);
        assertThat(held(played.canvas()) - first).isCloseTo(0.5, within(1e-9));
        played.turns(90);
        assertThat(held(played.canvas())).isEqualTo(1);
    }

    @Test
    void whatIsLostFadesInPieces() {
        PlayedLevel played = untilItIsLost(Motion.FULL);
        assertThat(held(played.canvas())).isZero();
        float first = pieces(played.canvas()).get(0);
        played.turns(LOST_TURNS / 2);
        assertThat(pieces(played.canvas()).get(0)).isLessThan(first);
        played.turns(LOST_TURNS / 2);
        assertThat(pieces(played.canvas())).isEmpty();
    }

    @Test
    void withReducedMotionItIsSeenAsLongAndDoesNotFade() {
        PlayedLevel played = untilItIsLost(Motion.REDUCED);
        played.turns(LOST_TURNS - 1);
        assertThat(pieces(played.canvas())).isNotEmpty().containsOnly(1f);
        played.turns(1);
        assertThat(pieces(played.canvas())).isEmpty();
    }

    @Test
    void isGoneAfterARestart() {
        PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());
        played.clickBox().turns(120);
        assertThat(held(played.canvas())).isPositive();
        played.keys(Key.R).turns(1);
        assertThat(held(played.canvas())).isZero();
        assertThat(pieces(played.canvas())).isEmpty();
    }
}
