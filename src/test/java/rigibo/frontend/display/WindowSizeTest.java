package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WindowSizeTest {

    /** The least of both ways, never enlarged; 1366 × 768 less 70 for panels leaves 0.8725. */
    @ParameterizedTest
    @CsvSource({
        "1920, 1080, 1, 1",
        "720, 800, 1, 1",
        "1366, 698, 1, 0.8725",
        "684, 1080, 1, 0.95",
        "1280, 600, 1, 0.85",
        "500, 1080, 1, 0.85",
        "2732, 1396, 2, 0.8725",
        "3840, 2100, 2, 1",
    })
    void theFirstWindowFitsTheScreen(double width, double height, double unit, double scale) {
        assertThat(WindowSize.scale(width, height, unit)).isEqualTo(scale);
    }
}
