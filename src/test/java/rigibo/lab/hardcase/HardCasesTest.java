package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.Set;
import java.util.stream.Stream;

/**
 * Every held case at GAME and EXACT, and at DRAFT where that is held to the limits of a game; at
 * the fastest of them twice, to the same bits. Long ones are run once, at that preset alone: {@code
 * ./rigibo cases} runs all at all presets. Its class derives a case's truth and limits.
 */
@Execution(ExecutionMode.CONCURRENT)
class HardCasesTest {

    /** Rows that took longer than ten seconds at some preset; together as long as all others. */
    private static final Set<String> LONG =
            Set.of("40", "60/wave", "64/turning", "M4/box", "M4/disc", "J1");

    static Stream<Arguments> heldCases() {
        return HardCases.held().stream().flatMap(HardCasesTest::atPresets);
    }

    private static Stream<Arguments> atPresets(HardCase hardCase) {
        return Stream.of(Preset.DRAFT, Preset.GAME, Preset.EXACT)
                .filter(preset -> isHeld(hardCase, preset))
                .limit(isLong(hardCase) ? 1 : Preset.values().length)
                .map(preset -> Arguments.of(hardCase.title(), preset, hardCase));
    }

    private static boolean isLong(HardCase hardCase) {
        return LONG.contains(hardCase.row());
    }

    private static boolean isHeld(HardCase hardCase, Preset preset) {
        return preset.compareTo(hardCase.fastest()) >= 0
                && preset.compareTo(hardCase.limitedFrom()) >= 0
                && (preset != Preset.DRAFT || hardCase.finding().isEmpty());
    }

    @ParameterizedTest(name = "{0} at {1}")
    @MethodSource("heldCases")
    void keepsToTheTruth(String title, Preset preset, HardCase hardCase) {
        Preset fastest = isHeld(hardCase, Preset.DRAFT) ? Preset.DRAFT : Preset.GAME;
        boolean isComparedWithItself = preset == fastest && !isLong(hardCase);
        HardCase.Result result =
                isComparedWithItself ? hardCase.run(preset) : hardCase.runOnce(preset);
        assertThat(result.worst().isReported()).as("nothing has a limit").isFalse();
        assertThat(result.passes()).as(result.toString()).isTrue();
    }

    /**
     * Rows that stand for stacks, ratios of masses, bullets, bounces, jams, seams, water and speed:
     * the whole list takes minutes, and asks the same of bodies in parts.
     */
    private static final Set<String> IN_PARTS =
            Set.of(
                    "10",
                    "15",
                    "20/10",
                    "20/20",
                    "20/untidy",
                    "21/large",
                    "23",
                    "26",
                    "40",
                    "44",
                    "47",
                    "49",
                    "51",
                    "55",
                    "56",
                    "58",
                    "60/arch",
                    "64",
                    "M9/few-boxes",
                    "M11/fast",
                    "origin/bobbing");

    static Stream<Arguments> casesInParts() {
        return HardCases.held().stream()
                .filter(hardCase -> IN_PARTS.contains(hardCase.row()))
                .map(hardCase -> Arguments.of(hardCase.title(), hardCase));
    }

    /** The truths and limits are those of bodies in one piece. */
    @ParameterizedTest(name = "{0}, in parts")
    @MethodSource("casesInParts")
    void keepsToTheTruthInParts(String title, HardCase hardCase) {
        HardCase.Result result = hardCase.runOnce(Preset.GAME, InParts::of);
        assertThat(result.passes()).as(result.toString()).isTrue();
    }
}
