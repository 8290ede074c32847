package rigibo.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import rigibo.Main;
import rigibo.backend.ChildJvm;

import java.io.IOException;
import java.util.List;

/**
 * Nothing grows while bodies come and go; in a JVM of its own, since it looks at the whole heap.
 */
@Execution(ExecutionMode.CONCURRENT)
class SoakTest {

    /** Laps that a pool is given to grow to its size, and some more. */
    private static final int LAPS = 25;

    @Test
    void poolDoesNotGrowWhileBodiesComeAndGo() throws IOException, InterruptedException {
        String printed =
                ChildJvm.output(
                        ChildJvm.own(),
                        List.of("-ea", "-XX:+UseSerialGC"),
                        Main.class,
                        "fuzz",
                        "--only",
                        "SOAK",
                        "--programs",
                        Integer.toString(LAPS));
        assertThat(printed).containsPattern("1[5-9],\\d{3} steps: nothing found");
    }
}
