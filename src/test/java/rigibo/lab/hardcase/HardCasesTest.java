package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.Stream;

/** Every held case at GAME and at EXACT; its class derives the truth and the limits. */
class HardCasesTest {

    static Stream<Arguments> heldCases() {
        return HardCases.held().stream()
                .flatMap(
                        hardCase ->
                                Stream.of(Preset.GAME, Preset.EXACT)
                                        .filter(preset -> isCounted(hardCase, preset))
                                        .map(
                                                preset ->
                                                        Arguments.of(
                                                                hardCase.title(),
                                                                preset,
                                                                hardCase)));
    }

    private static boolean isCounted(HardCase hardCase, Preset preset) {
        return preset.compareTo(hardCase.fastest()) >= 0;
    }

    @ParameterizedTest(name = "{0} at {1}")
    @MethodSource("heldCases")
    void keepsToTheTruth(String title, Preset preset, HardCase hardCase) {
        HardCase.Result result = hardCase.run(preset);
        assertThat(result.measures()).isNotEmpty();
        assertThat(result.passes()).as(result.toString()).isTrue();
    }
}
