package rigibo.frontend.puzzle.show;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;

/**
 * Whatever is open, the play of a level is between its foot and the keys, and inside the window,
 * before what its gravity tells.
 */
class ViewTest {

    private static final double SKY = 0.7;
    private static final double GROUND = 0.4;

    @ParameterizedTest
    @CsvSource({"9, 10, 56", "9, 10, 124", "9, 10, 250", "18, 10, 56", "9, 20, 56", "18, 20, 124"})
    void thePlayFitsBetween(double width, double height, double foot) {
        View view =
                new View(
                        LevelTexts.level(
                                LevelTexts.with(
                                        "\"width\": 9, \"height\": 10",
                                        "\"width\": " + width + ", \"height\": " + height)));
        view.fitBelow(foot);
        Camera camera = view.camera();
        assertThat(camera.screenY(height - SKY)).isGreaterThan(foot - 1e-9);
        assertThat(camera.screenY(GROUND)).isLessThan(View.KEYS_TOP + 1e-9);
        assertThat(camera.screenX(0)).isGreaterThan(-1e-9);
        assertThat(camera.screenX(width)).isLessThan(Scene.WIDTH + 1e-9);
        assertThat(camera.screenX(width / 2)).isCloseTo(Scene.WIDTH / 2.0, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"0, -9.81, WORKSHOP", "0, -1.62, MOON", "0, 0, WORKSHOP", "1.62, -1.62, WORKSHOP"})
    void whereThingsFallAsOnTheMoonTheMoonIsSeen(double x, double y, Scenery seen) {
        String gravity = "[" + x + ", " + y + "]";
        View view = new View(LevelTexts.level(LevelTexts.with("[0, -9.81]", gravity)));
        assertThat(view.scenery()).isEqualTo(seen);
    }
}
