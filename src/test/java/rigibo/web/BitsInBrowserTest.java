package rigibo.web;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import java.io.IOException;
import java.nio.file.Path;

/**
 * The engine, compiled for a browser, gives the bits of the JVM. Where there is no browser, or what
 * compiles it was never fetched, nothing is tested, and the test says so.
 */
@Execution(ExecutionMode.CONCURRENT)
class BitsInBrowserTest {

    @TempDir private Path folder;

    @Test
    void randomProgramsProofsAndRecordedRunsEndInTheSameState()
            throws IOException, InterruptedException {
        assertThat(WebProgram.run(folder, "--bits"))
                .contains("144 of 144 programs, proofs and runs have the bits of the JVM");
    }
}
