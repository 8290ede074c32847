package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.Stream;

/**
 * Every held case at GAME and at EXACT, and at DRAFT where that is held to the limits of a game;
 * its class derives the truth and the limits.
 */
class HardCasesTest {

    static Stream<Arguments> heldCases() {
        return HardCases.held().stream()
                .flatMap(
                        hardCase ->
                                Stream.of(Preset.DRAFT, Preset.GAME, Preset.EXACT)
                                        .filter(preset -> isHeld(hardCase, preset))
                                        .map(
                                                preset ->
                                                        Arguments.of(
                                                                hardCase.title(),
                                                                preset,
                                                                hardCase)));
    }

    private static boolean isHeld(HardCase hardCase, Preset preset) {
        return preset.compareTo(hardCase.fastest()) >= 0
                && preset.compareTo(hardCase.limitedFrom()) >= 0
                && (preset != Preset.DRAFT || hardCase.finding().isEmpty());
    }

    @ParameterizedTest(name = "{0} at {1}")
    @MethodSource("heldCases")
    void keepsToTheTruth(String title, Preset preset, HardCase hardCase) {
        HardCase.Result result = hardCase.run(preset);
        assertThat(result.worst().isReported()).as("nothing has a limit").isFalse();
        assertThat(result.passes()).as(result.toString()).isTrue();
    }
}
