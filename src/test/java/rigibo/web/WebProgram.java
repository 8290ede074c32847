package rigibo.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;

/** {@code ./rigibo web} as a process of its own, since what compiles pages is not on this path. */
final class WebProgram {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    private WebProgram() {}

    /**
     * Runs it on a folder; returns what it said. Where there is no browser, or what compiles pages
     * was never fetched, the test is given up, and says so.
     */
    static String run(Path folder, String argument) throws IOException, InterruptedException {
        Path places = HOME.resolve("build/start/web.classpath");
        assumeTrue(
                Files.exists(places), "./rigibo web was never asked for: what it needs is missing");
        String classPath =
                Files.readAllLines(places).stream()
                        .map(place -> place.replace("@checkout@", HOME.toString()))
                        .collect(Collectors.joining(File.pathSeparator));
        Path said = folder.resolve("said");
        Process process =
                new ProcessBuilder(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "-XX:+UseSerialGC",
                                // Collecting the compiler's garbage from a small heap took a
                                // quarter of its time.
                                "-Xms2g",
                                "-Xmn1200m",
                                // So short a run would not win back what the optimizing compiler
                                // takes.
                                "-XX:TieredStopAtLevel=1",
                                "-Drigibo.home=" + HOME,
                                "-cp",
                                classPath,
                                "rigibo.web.build.WebCommand",
                                folder.resolve("page").toString(),
                                argument)
                        .redirectErrorStream(true)
                        .redirectOutput(said.toFile())
                        .start();
        int status = process.waitFor();
        String words = Files.readString(said);
        assertThat(status).as(words).isZero();
        assumeTrue(!words.contains("There is no Chromium"), words);
        return words;
    }
}
