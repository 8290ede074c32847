package rigibo.examples;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.Accuracy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;

/** The code shown in the README and in the page on the step compiles and runs. */
class ReadmeTest {

    private static final Path EXAMPLE =
            Path.of("src/examples/java/rigibo/examples/FallingCrate.java");

    @Test
    void showsTheExampleThatCompiles() throws IOException {
        String source = Files.readString(EXAMPLE);
        String shown =
                source.substring(
                                source.indexOf("// README begins\n")
                                        + "// README begins\n".length(),
                                source.indexOf("        // README ends"))
                        .lines()
                        .map(line -> line.substring(8))
                        .collect(Collectors.joining("\n"));
        assertThat(Files.readString(Path.of("README.md"))).contains(shown);
    }

    @Test
    void showsThePlanOfTheUsualPool() throws IOException {
        String plan = new Pool().plan().lines().collect(Collectors.joining("\n"));
        assertThat(Files.readString(Path.of("docs/how-a-step-works.md")))
                .contains("```\n" + plan + "\n```");
        assertThat(new Pool(Effects.of(new Gravity(0, -9.81)), Accuracy.GAME).plan().lines())
                .hasSize(7 + 1);
    }

    @Test
    void theExampleEndsAtRest() {
        PrintStream before = System.out;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        try {
            FallingCrate.main(new String[0]);
        } finally {
            System.setOut(before);
        }
        assertThat(printed.toString(StandardCharsets.UTF_8)).contains("RigidBody at");
    }
}
