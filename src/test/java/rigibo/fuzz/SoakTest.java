package rigibo.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

import rigibo.fuzz.Fuzz.Only;
import rigibo.fuzz.judge.Tally;

import java.nio.file.Path;

/** Nothing grows while bodies come and go; alone, since it looks at the whole heap. */
@Isolated
class SoakTest {

    /** Laps that a pool is given to grow to its size, and some more. */
    private static final int LAPS = 25;

    @TempDir Path wrong;

    @Test
    void poolDoesNotGrowWhileBodiesComeAndGo() throws InterruptedException {
        Fuzz fuzz = new Fuzz(Only.SOAK, wrong);
        FuzzTest.requireNothingWrong(fuzz, Order.counted(LAPS, 0, FuzzTest.SEED, 0));
        assertThat(fuzz.tally().of(Tally.Of.STEPS)).isGreaterThan(LAPS * 600L);
    }
}
