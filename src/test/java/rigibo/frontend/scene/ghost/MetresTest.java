package rigibo.frontend.scene.ghost;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.frontend.scene.Words;

/** Lengths have the unit in which they are a small number. */
class MetresTest {

    @ParameterizedTest
    @CsvSource({
        "0, 0 m",
        "4.216, 4.22 m",
        "12.34, 12.3 m",
        "0.9999, 1.00 m",
        "0.25, 250 mm",
        "3.2e-5, 32.0 µm",
        "4e-9, 4.00 nm",
        "6e-13, 0.60 pm",
        "1e-15, 0 m"
    })
    void lengthsAreSmallNumbers(double metres, String words) {
        assertThat(Metres.words(new Words("en"), metres)).isEqualTo(words);
    }

    @Test
    void aLengthHasTheDecimalMarkOfItsLanguage() {
        assertThat(Metres.words(new Words("de"), 3.2e-5)).isEqualTo("32,0 µm");
    }
}
