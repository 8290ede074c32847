package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Bodies that fall on bridges as long as their span; not all limits of the case itself are reached.
 */
@Execution(ExecutionMode.CONCURRENT)
class TautBridgesTest {

    /** m: a share of a plank's height that may be overlap, a fiftieth. */
    private static final double GAPE = 2.5e-3;

    @ParameterizedTest
    @CsvSource({
        "DRAFT, 1",
        "DRAFT, 2",
        "DRAFT, 3",
        "GAME, 1",
        "GAME, 2",
        "GAME, 3",
        "GAME, 7",
        "GAME, 9"
    })
    void stayClosedAndGainNothing(Preset preset, long seed) {
        Sampling sampling = new Sampling(Sampling.Extent.SMALL, seed);
        HardCase.Result result =
                HardCase.of("J12/taut", "", TautBridges::fallOnAll).run(preset, sampling);
        assertThat(figure(result, "error of joints").figure()).isLessThan(GAPE);
        assertThat(figure(result, "energy beyond the start").passes())
                .as(result.toString())
                .isTrue();
    }

    private static Measure figure(HardCase.Result result, String name) {
        return result.measures().stream()
                .filter(measure -> measure.name().equals(name))
                .findFirst()
                .orElseThrow();
    }
}
