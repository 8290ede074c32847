package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bodies that fall on bridges as long as their span. */
@Execution(ExecutionMode.CONCURRENT)
class TautBridgesTest {

    @ParameterizedTest
    @CsvSource({
        "DRAFT, 1",
        "DRAFT, 2",
        "DRAFT, 3",
        "GAME, 1",
        "GAME, 2",
        "GAME, 3",
        "GAME, 7",
        "GAME, 9",
        "FINE, 2",
        "FINE, 5"
    })
    void stayClosedAndGainNothing(Preset preset, long seed) {
        Sampling sampling = new Sampling(Sampling.Extent.SMALL, seed);
        HardCase.Result result =
                HardCase.of("J12/taut", "", TautBridges::fallOnAll).run(preset, sampling);
        assertThat(result.passes()).as(result.toString()).isTrue();
    }
}
