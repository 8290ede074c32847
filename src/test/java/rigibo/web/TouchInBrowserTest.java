package rigibo.web;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;

/**
 * A level is played to its verdict by touch, in a browser as large as a phone, one is made in the
 * editor by touch and another beside the page, and what screen readers are told is asked for: under
 * a policy that allows no code from texts, nothing is written to its console, and nothing is asked
 * for beyond the page's folder. Where there is no browser, or what compiles the page was never
 * fetched, nothing is tested, and the test says so.
 */
class TouchInBrowserTest {

    @TempDir private Path folder;

    @Test
    void levelsAreSolvedAndMadeByFingers() throws IOException, InterruptedException {
        assertThat(WebProgram.run(folder, "--touch-one"))
                .contains("1 of 1 levels were solved by touch")
                .contains("level made by touch: enlarged true, saved true, won true")
                .contains("menu read: true, calm: true")
                .contains("beside the page: made");
    }
}
