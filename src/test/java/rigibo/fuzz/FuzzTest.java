package rigibo.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import rigibo.fuzz.Fuzz.Only;
import rigibo.fuzz.judge.Tally;

import java.nio.file.Path;
import java.util.List;

/**
 * The engine and the game survive random input. {@code ./rigibo fuzz} tries more; the message of a
 * failure says how to repeat it.
 */
@Execution(ExecutionMode.CONCURRENT)
class FuzzTest {

    static final long SEED = 1;
    private static final int PROGRAMS = 120;
    private static final int FILES = 400;

    @TempDir Path wrong;

    @Test
    void engineBearsRandomPrograms() throws InterruptedException {
        Fuzz fuzz = new Fuzz(Only.ENGINE, wrong);
        requireNothingWrong(fuzz, Order.counted(PROGRAMS, 0, SEED, 0));
        assertThat(fuzz.tally().of(Tally.Of.PROGRAMS)).isEqualTo(PROGRAMS);
        for (Tally.Of what :
                List.of(Tally.Of.STEPS, Tally.Of.QUERIES, Tally.Of.COPIES, Tally.Of.REFUSALS)) {
            assertThat(fuzz.tally().of(what)).as("%s", what).isGreaterThan(PROGRAMS);
        }
    }

    @Test
    void gameBearsMutatedFiles() throws InterruptedException {
        Fuzz fuzz = new Fuzz(Only.FILES, wrong);
        requireNothingWrong(fuzz, Order.counted(0, FILES, SEED, 0));
        long refused = fuzz.tally().of(Tally.Of.FILES_REFUSED);
        assertThat(fuzz.tally().of(Tally.Of.FILES)).isEqualTo(FILES);
        assertThat(refused).isBetween(FILES / 10L, FILES - FILES / 50L);
    }

    static void requireNothingWrong(Fuzz fuzz, Order order) throws InterruptedException {
        List<String> found = fuzz.run(order, progress -> {});
        assertThat(found).as("%s", String.join("\n", found)).isEmpty();
    }
}
