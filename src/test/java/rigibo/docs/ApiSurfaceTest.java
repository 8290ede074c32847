package rigibo.docs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;

/** No public name of the engine goes, changes or comes unnoticed. */
class ApiSurfaceTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    /** Where a change is meant, {@code ./rigibo docs} writes the file anew. */
    @Test
    void theSurfaceIsTheOneThatIsWritten() throws IOException, URISyntaxException {
        String written = Files.readString(HOME.resolve(DocsWriter.SURFACE));
        assertThat(ApiSurface.text(HOME).lines())
                .as("the engine's public names; ./rigibo docs writes them anew")
                .containsExactlyElementsOf(written.lines().toList());
    }

    @Test
    void theSurfaceHasTheFaceAndNothingElse() throws IOException, URISyntaxException {
        assertThat(ApiSurface.text(HOME).lines())
                .contains(
                        "package rigibo.backend.setup",
                        "final class Pool implements AutoCloseable",
                        "    StepReport step(double)",
                        "record Circle(double radius) implements Convex")
                .noneMatch(line -> line.contains("storage"));
    }
}
