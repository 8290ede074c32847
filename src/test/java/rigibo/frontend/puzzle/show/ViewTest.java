package rigibo.frontend.puzzle.show;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Scenery;

/**
 * With any drawer open, the play of a level lies between its upper edge and the keys, within the
 * window, in front of the scenery of its gravity.
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

    /** Levels made by chance may begin so. */
    @ParameterizedTest
    @CsvSource({"56", "124"})
    void aBallThatBeginsInTheMarginIsSeenWhole(double foot) {
        View view = new View(LevelTexts.level(LevelTexts.with("\"y\": 2.7", "\"y\": 9.5")));
        view.fitBelow(foot);
        Camera camera = view.camera();
        assertThat(camera.screenY(9.5 + 0.35)).isGreaterThan(foot - 1e-9);
        assertThat(camera.screenY(GROUND)).isLessThan(View.KEYS_TOP + 1e-9);
    }

    /**
     * The point between the fingers stays in place, and the picture never shows more than before.
     */
    @ParameterizedTest
    @CsvSource({"2, 0, 0", "3, 30, -20", "1.3, 5, 5"})
    void twoFingersEnlargeWhatIsBetweenThem(double factor, double dx, double dy) {
        View view = new View(LevelTexts.sound());
        Camera camera = view.camera();
        double x = camera.worldX(350 - dx);
        double y = camera.worldY(400 - dy);
        double scale = camera.scale();
        view.pinch(new Pinch(factor, 350, 400, dx, dy));
        assertThat(camera.worldX(350)).isCloseTo(x, within(1e-9));
        assertThat(camera.worldY(400)).isCloseTo(y, within(1e-9));
        assertThat(camera.scale()).isCloseTo(factor * scale, within(1e-9));
        assertThat(view.isEnlarged()).isTrue();
    }

    @Test
    void whatIsEnlargedStaysWithinTheWholePicture() {
        View view = new View(LevelTexts.sound());
        Camera camera = view.camera();
        double left = camera.worldX(0);
        double top = camera.worldY(View.BAR_FOOT);
        double bottom = camera.worldY(View.KEYS_TOP);
        view.pinch(new Pinch(2, 100, 100, 5000, -5000));
        assertThat(camera.worldX(0)).isCloseTo(left, within(1e-9));
        assertThat(camera.worldY(View.KEYS_TOP)).isCloseTo(bottom, within(1e-9));
        view.pinch(new Pinch(1, 100, 100, 0, 5000));
        assertThat(camera.worldY(View.BAR_FOOT)).isCloseTo(top, within(1e-9));
        view.pinch(new Pinch(0.1, 100, 100, 300, 300));
        assertThat(view.isEnlarged()).isFalse();
        assertThat(camera.worldX(0)).isCloseTo(left, within(1e-9));
        assertThat(camera.worldY(View.KEYS_TOP)).isCloseTo(bottom, within(1e-9));
    }

    @Test
    void theWholePictureComesBackAsItWas() {
        View view = new View(LevelTexts.sound());
        double x = view.camera().screenX(3);
        double y = view.camera().screenY(2);
        view.pinch(new Pinch(3, 200, 300, 20, 40));
        view.fitBelow(124);
        view.fitBelow(View.BAR_FOOT);
        view.showAll();
        assertThat(view.camera().screenX(3)).isEqualTo(x);
        assertThat(view.camera().screenY(2)).isEqualTo(y);
    }

    @ParameterizedTest
    @CsvSource({"0, -9.81, WORKSHOP", "0, -1.62, MOON", "0, 0, WORKSHOP", "1.62, -1.62, WORKSHOP"})
    void whereThingsFallAsOnTheMoonTheMoonIsSeen(double x, double y, Scenery seen) {
        String gravity = "[" + x + ", " + y + "]";
        View view = new View(LevelTexts.level(LevelTexts.with("[0, -9.81]", gravity)));
        assertThat(view.scenery()).isEqualTo(seen);
    }
}
