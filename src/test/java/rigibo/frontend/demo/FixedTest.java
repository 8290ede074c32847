package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.scene.Words;

class FixedTest {

    @ParameterizedTest
    @CsvSource({
        "-0.0004, 0.000 m/s",
        "-0.0, 0.000 m/s",
        "0.0004, 0.000 m/s",
        "-0.0006, -0.001 m/s",
        "-12.5, -12.500 m/s",
        "4.3725, 4.373 m/s"
    })
    void onlyWhatRoundsToZeroLosesItsSign(double value, String words) {
        assertThat(Fixed.words(new Words("en"), "%.3f m/s", value)).isEqualTo(words);
    }
}
