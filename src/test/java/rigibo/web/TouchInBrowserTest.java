package rigibo.web;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;

/**
 * The first level of each world is played to its verdict by touch, in a browser as large as a
 * phone, one is made in the editor by touch and another beside the page, and what screen readers
 * are told is asked for: under a policy that allows no code from texts, nothing is written to its
 * console, and nothing is asked for beyond the page's folder. The page is played without a server
 * after the first visit, and says what the browser lacks or refuses. Where there is no browser, or
 * what compiles the page was never fetched, nothing is tested, and the test says so.
 */
class TouchInBrowserTest {

    @TempDir private Path folder;

    @Test
    void levelsAreSolvedAndMadeByFingers() throws IOException, InterruptedException {
        assertThat(WebProgram.run(folder, "--sample"))
                .contains("4 of 4 levels were solved by touch")
                .contains(
                        "level made by touch: enlarged true, saved true, won true,"
                                + " refusal told true")
                .contains("menu read: true, calm: true")
                .contains("beside the page: made")
                .contains(
                        "told: storage denied true, full true and kept later true, no WebGL true,"
                                + " no WebAssembly true")
                .contains(
                        "without a server: installable true, opened from the browser true, solved"
                                + " true");
    }
}
