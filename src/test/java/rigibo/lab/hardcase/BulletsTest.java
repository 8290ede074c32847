package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Heavy bullets pass through nothing; at EXACT some boxes enter the floor, as their row tells. */
@Execution(ExecutionMode.CONCURRENT)
class BulletsTest {

    @ParameterizedTest
    @CsvSource({"M3, GAME", "M3, FINE", "M3/hardest, GAME", "M3/hardest, FINE"})
    void bulletsPassThroughNothing(String row, Preset preset) {
        HardCase bullets =
                HardCases.all().stream()
                        .filter(hardCase -> hardCase.row().equals(row))
                        .findAny()
                        .orElseThrow();
        HardCase.Result result = bullets.runOnce(preset);
        assertThat(result.passes()).as(result.toString()).isTrue();
    }
}
