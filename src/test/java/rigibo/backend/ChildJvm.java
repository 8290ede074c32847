package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Java processes of their own: a fresh heap, other compilers. */
public final class ChildJvm {

    private static final int SECONDS = 120;

    private ChildJvm() {}

    /** The Java that runs the tests. */
    public static Path own() {
        return Path.of(System.getProperty("java.home"));
    }

    /**
     * Runs a main class to its end with the class path of the tests, and returns what it prints.
     */
    public static String output(Path home, List<String> options, Class<?> main, String... arguments)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(home.resolve("bin/java").toString());
        command.addAll(options);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String printed =
                new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(SECONDS, TimeUnit.SECONDS)).as("%s ends", home).isTrue();
        assertThat(process.exitValue()).as("%s %s: %s", home, options, printed).isZero();
        return printed.strip();
    }
}
