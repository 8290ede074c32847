package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Java processes of their own: a fresh heap, other compilers, other versions. */
final class ChildJvm {

    private static final Path HOMES = Path.of("/usr/lib/jvm");
    private static final int OLDEST = 17;
    private static final int SECONDS = 120;

    private ChildJvm() {}

    /** The Java that runs the tests. */
    static Path own() {
        return Path.of(System.getProperty("java.home"));
    }

    /** Other Javas installed here that can run what was built, each once. */
    static List<Path> others() throws IOException {
        if (!Files.isDirectory(HOMES)) {
            return List.of();
        }
        Path own = own().toRealPath();
        List<Path> found = new ArrayList<>();
        try (Stream<Path> homes = Files.list(HOMES)) {
            for (Path home : homes.sorted().collect(Collectors.toList())) {
                Path real = home.toRealPath();
                if (!real.equals(own) && !found.contains(real) && versionOf(real) >= OLDEST) {
                    found.add(real);
                }
            }
        }
        return found;
    }

    private static int versionOf(Path home) throws IOException {
        Path release = home.resolve("release");
        if (!Files.isExecutable(home.resolve("bin/java")) || !Files.exists(release)) {
            return 0;
        }
        return Files.readAllLines(release).stream()
                .filter(line -> line.startsWith("JAVA_VERSION="))
                .map(line -> line.replaceAll("[^0-9.]", "").split("\\.")[0])
                .mapToInt(Integer::parseInt)
                .findFirst()
                .orElse(0);
    }

    /**
     * Runs a main class to its end with the class path of the tests, and returns what it prints.
     */
    static String output(Path home, List<String> options, Class<?> main, String... arguments)
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
