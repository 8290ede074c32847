package rigibo.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;

/**
 * The engine, compiled for a browser, gives the bits of the JVM. Where there is no browser, or what
 * compiles it was never fetched, nothing is tested, and the test says so.
 */
class BitsInBrowserTest {

    private static final Path HOME = Path.of(System.getProperty("rigibo.home", ""));

    @TempDir private Path folder;

    @Test
    void randomProgramsAndRecordedRunsEndInTheSameState() throws IOException, InterruptedException {
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
                                "-Drigibo.home=" + HOME,
                                "-cp",
                                classPath,
                                "rigibo.web.build.WebCommand",
                                folder.toString(),
                                "--bits")
                        .redirectErrorStream(true)
                        .redirectOutput(said.toFile())
                        .start();
        int status = process.waitFor();
        String words = Files.readString(said);
        assertThat(status).as(words).isZero();
        assumeTrue(!words.contains("There is no Chromium"), words);
        assertThat(words).contains("140 of 140 programs and runs have the bits of the JVM");
    }
}
