package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Execution(ExecutionMode.CONCURRENT)
class FlatPlateBowlTest {

    /**
     * Both corners of the box land at every kink, and between kinks energy is kept. Tolerances are
     * those of the case: 3 % of what the kinks took and 1e-3 of the start. A trailing corner that
     * is not awaited lands too late, and took 6 to 30 % of what the kinks take on top: of plates
     * that reach below their neighbours, for its point lay inside of them, and of plates that it
     * comes over within a substep, for it was not over them yet when the leading corner landed.
     */
    @ParameterizedTest(name = "{0} plates of {1} chords, in a bowl of {2} m")
    @CsvSource({"60, 1.4, 4.65", "333, 1.2, 3.29", "1500, 1, 4.39"})
    void boxLosesWhatTheKinksTake(int plates, double lap, double radius) {
        Trial trial = new Trial(Preset.GAME, Preset.GAME, Sampling.USUAL, body -> body, 1);
        FlatPlateBowl.BOX.swing(trial, new PlateBowl(radius, plates, lap));
        assertThat(trial.measures()).allMatch(Measure::passes);
    }
}
